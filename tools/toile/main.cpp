// toile: one command in front of all programs. `toile dress ...` is dress.
#include <algorithm>
#include <iostream>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "tools/programs.h"

namespace toile {

namespace {

/// What follows "toile" on the command line.
std::string command_of(const CommandLineProgram& program) {
  return program.name.substr(program.name.find(' ') + 1);
}

/// How many letters have to be put in, left out or changed to get from one word to the other.
std::size_t edits(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), 0U);
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t changed = diagonal + (from[i] != to[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

void print_help(std::ostream& stream) {
  stream << "toile: " << toile_summary()
         << "\n\nusage: toile COMMAND [arguments]\n       toile COMMAND --help\n\ncommands:\n";
  for (const CommandLineProgram& program : all_programs()) {
    std::string command = command_of(program);
    command.resize(16, ' ');
    stream << "  " << command << program.summary << '\n';
  }
}

int run(int argc, char** argv) {
  const std::string command = argc > 1 ? argv[1] : "";
  if (command.empty()) {
    print_help(std::cerr);
    return exit_usage;
  }
  if (command == "--help" || command == "-h") {
    print_help(std::cout);
    return exit_done;
  }
  if (command == "--version") {
    print_version("toile");
    return exit_done;
  }
  const std::vector<CommandLineProgram> programs = all_programs();
  for (const CommandLineProgram& program : programs) {
    if (command == command_of(program)) return run_program(argc - 1, argv + 1, program);
  }
  const auto nearest = std::ranges::min_element(
      programs, {}, [&](const auto& program) { return edits(command, command_of(program)); });
  std::cerr << "toile: '" << command << "' is no command, '" << command_of(*nearest)
            << "' is the nearest; toile --help lists all\n";
  return exit_usage;
}

}  // namespace

}  // namespace toile

int main(int argc, char** argv) { return toile::run(argc, argv); }
