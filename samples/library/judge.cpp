// Judges a drape that was pushed 5 mm to the left: it crosses the body.
//   judge PATTERN.json
#include <iostream>

#include "toile/clean.h"
#include "toile/dress.h"
#include "toile/files.h"
#include "toile/mesh.h"

int main(int argc, char** argv) try {
  if (argc != 2) throw toile::Error("judge", "needs a file", "give PATTERN.json");
  const toile::Garment garment = toile::mesh(toile::read_pattern(argv[1]), {.edge_length = 0.025});
  const toile::Body body = toile::mannequin();
  toile::Drape drape = toile::dress(garment, body, {.quality = "draft"});
  for (toile::Point& point : drape.points) point[0] += 0.005;
  std::cout << toile::judge(drape, body);
} catch (const toile::Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
