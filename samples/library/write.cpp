// Writes a body, a meshed garment and its drape as the programs' files, and reads the drape again.
//   write PATTERN.json FOLDER
#include <iostream>

#include "toile/clean.h"
#include "toile/dress.h"
#include "toile/files.h"
#include "toile/mesh.h"

int main(int argc, char** argv) try {
  if (argc != 3) throw toile::Error("write", "needs two files", "give PATTERN.json FOLDER");
  const std::filesystem::path folder = argv[2];
  const toile::Garment garment = toile::mesh(toile::read_pattern(argv[1]), {.edge_length = 0.025});
  const toile::Body body = toile::mannequin();
  const toile::Drape drape = toile::dress(garment, body, {.quality = "draft"});
  toile::write(body, folder / "body.ply");
  toile::write(garment, folder / "garment.obj");
  toile::write(drape, folder / "dressed.obj");
  const bool same = toile::read_drape(folder / "dressed.obj", garment).points == drape.points;
  std::cout << (same ? "the same bits\n" : "other bits\n");
  return same ? 0 : 1;
} catch (const toile::Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
