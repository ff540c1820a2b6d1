// Prints the measures of a mannequin that was made to three.
//   measure
#include "toile/measure.h"

#include <iostream>

#include "toile/clean.h"

int main() try {
  const toile::Body body = toile::mannequin({{"height", 168}, {"bust", 96}, {"hip", 104}}, "woman");
  std::cout << toile::measure(body, {.freehand = {"girth plane=hip tilt=10deg name=sloping"}});
} catch (const toile::Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
