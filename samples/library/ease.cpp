// Prints the ease of a draft drape, and how far the cloth stands off the skin at most.
//   ease PATTERN.json
#include "toile/ease.h"

#include <algorithm>
#include <iostream>

#include "toile/clean.h"
#include "toile/dress.h"
#include "toile/files.h"
#include "toile/mesh.h"

int main(int argc, char** argv) try {
  if (argc != 2) throw toile::Error("ease", "needs a file", "give PATTERN.json");
  const toile::Garment garment = toile::mesh(toile::read_pattern(argv[1]), {.edge_length = 0.025});
  const toile::Body body = toile::mannequin();
  const toile::Drape drape = toile::dress(garment, body, {.quality = "draft"});
  std::cout << toile::ease(drape, body, {.target = "fitted"});
  std::cerr << 1000 * std::ranges::max(toile::gaps(drape, body)) << " mm\n";
} catch (const toile::Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
