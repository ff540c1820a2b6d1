// Meshes a pattern at 25 mm.
//   mesh PATTERN.json
#include "toile/mesh.h"

#include <iostream>

#include "toile/files.h"

int main(int argc, char** argv) try {
  if (argc != 2) throw toile::Error("mesh", "needs a file", "give PATTERN.json");
  const toile::Garment garment = toile::mesh(toile::read_pattern(argv[1]), {.edge_length = 0.025});
  std::cout << garment.flat.size() << " material points, " << garment.triangles.size()
            << " triangles\n";
} catch (const toile::Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
