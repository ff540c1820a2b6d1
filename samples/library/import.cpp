// Makes a pattern of a drawing.
//   import DRAWING PATTERN.json
#include "toile/import.h"

#include <iostream>

#include "toile/files.h"

int main(int argc, char** argv) try {
  if (argc != 3) throw toile::Error("import", "needs two files", "give DRAWING PATTERN.json");
  const toile::SewingPattern pattern = toile::import_pattern(argv[1]);
  toile::write(pattern, argv[2]);
  std::cout << pattern.report;
} catch (const toile::Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
