// Finds the seams of a pattern anew, whatever seams it states.
//   find_seams PATTERN.json SEWN.json
#include "toile/find_seams.h"

#include <iostream>

#include "toile/files.h"

int main(int argc, char** argv) try {
  if (argc != 3) throw toile::Error("find_seams", "needs two files", "give PATTERN.json SEWN.json");
  const toile::SewingPattern sewn = toile::find_seams(toile::read_pattern(argv[1]));
  toile::write(sewn, argv[2]);
  std::cout << sewn.report;
} catch (const toile::Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
