// Reads a body, and says how many points its skin has and whether its joints are known.
//   read BODY
#include <iostream>

#include "toile/files.h"

int main(int argc, char** argv) try {
  if (argc != 2) throw toile::Error("read", "needs a file", "give BODY");
  const toile::Body body = toile::read_body(argv[1]);
  std::cout << body.points.size() << " points, joints are "
            << (body.joints.empty() ? "not known\n" : "known\n");
} catch (const toile::Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
