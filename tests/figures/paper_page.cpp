// Gathers what the figure programs wrote into FOLDER to FOLDER/index.html.
#include <iostream>

#include "io/output_file.h"
#include "tests/figures/page.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: paper-page FOLDER\n";
    return 2;
  }
  try {
    const std::filesystem::path page = std::filesystem::path(argv[1]) / "index.html";
    toile::write_file(page, toile::figures::figures_page(argv[1]));
    std::cerr << "wrote " << page.string() << "\n";
  } catch (const std::exception& error) {
    std::cerr << "paper-page: " << error.what() << "\n";
    return 1;
  }
}
