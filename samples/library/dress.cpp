// Dresses the sample mannequin in poplin, and prints the report.
//   dress PATTERN.json
#include "toile/dress.h"

#include <iostream>

#include "toile/clean.h"
#include "toile/files.h"
#include "toile/mesh.h"

int main(int argc, char** argv) try {
  if (argc != 2) throw toile::Error("dress", "needs a file", "give PATTERN.json");
  const toile::Garment garment = toile::mesh(toile::read_pattern(argv[1]), {.edge_length = 0.025});
  const toile::Drape drape = toile::dress(garment, toile::mannequin(), {.fabric = "cotton-poplin"});
  std::cout << drape.report;
} catch (const toile::Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
