// main() of every program; CMake says which one TOILE_PROGRAM is.
#include "tools/programs.h"

int main(int argc, char** argv) { return toile::run_program(argc, argv, toile::TOILE_PROGRAM()); }
