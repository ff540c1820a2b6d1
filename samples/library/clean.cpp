// Makes a mesh of a person a body that can be dressed.
//   clean MESH BODY
#include "toile/clean.h"

#include <iostream>

#include "toile/files.h"

int main(int argc, char** argv) try {
  if (argc != 3) throw toile::Error("clean", "needs two files", "give MESH BODY");
  toile::CleanChoices choices;
  choices.up = "y";  // what is not said is found
  const toile::Body body = toile::clean(toile::read_mesh(argv[1]), choices);
  toile::write(body, argv[2]);
  std::cout << body.report;
} catch (const toile::Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
