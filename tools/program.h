// What all programs have in common: the shared options, messages and exit codes.
#pragma once

#include <boost/program_options.hpp>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "tools/program_files.h"

namespace toile {

/// Exit codes of every program.
enum ExitCode : int {
  exit_done = 0,
  exit_error = 1,     ///< input or processing error; one message on stderr
  exit_usage = 2,     ///< wrong options
  exit_negative = 3,  ///< done and written, but the verdict is negative
};

/// The options that every program has.
struct CommonSettings {
  std::filesystem::path output;                 ///< -o
  std::optional<std::filesystem::path> report;  ///< --report
  int threads = 0;                              ///< --threads; 0: as many as the machine has
  bool quiet = false;                           ///< -q
  std::string program = {};                     ///< its name, for the report
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

  /// A line for the user on stderr, unless -q. stdout is for data alone.
  void say(const std::string& line) const;
  /// A warning on stderr, -q or not. A program that links the library has the warnings in reports
  /// only: there it says nothing.
  static void warn(const std::string& line);
};

/// A value that an option can't take: exit code 2, as for an option that is not there.
class UsageError : public Error {
 public:
  using Error::Error;
  explicit UsageError(const Error& wrong) : Error(wrong) {}
};

/// What a command line asks for. Its work returns an exit code.
struct Job {
  ProgramFiles files;  ///< the report need not be among them
  std::function<int()> work;
};

/// A program: its name, its purpose in a line, its usage, its own options and positional arguments.
struct CommandLineProgram {
  std::string name;
  std::string summary;
  std::string usage;  ///< the arguments, without the program's name
  boost::program_options::options_description options{"Options"};
  boost::program_options::positional_options_description positional;
  std::string footer = {};  ///< what --help and the manual say below the options
  /// Options that hang on one another, where there are such: throws program_options::error.
  std::function<void(const boost::program_options::variables_map&)> check;
  /// What -o has to end in, ".obj" say; none: the program looks at it itself.
  std::vector<std::string> output_extensions;
  /// Other options of files: where one of them is given, -o may be left out, and is empty.
  std::vector<std::string> instead_of_output = {};
  /// -o is a folder for files of fixed names, the report among them: there is no --report.
  bool writes_folder = false;
  /// Reads no more than it takes to know all files. What it is given outlives the job.
  std::function<Job(const boost::program_options::variables_map&, const CommonSettings&)> prepare;
};

/// The options that every program has, as --help prints them.
boost::program_options::options_description common_options(const CommandLineProgram& program);

/// Runs a program. It parses the command line, answers --help and --version, limits the threads,
/// checks that no file would be lost, and does the work. An exception becomes one message and its
/// exit code. -o is required, but for instead_of_output. A signal that ends the program leaves no
/// temporary file.
int run_program(int argc, char** argv, const CommandLineProgram& program);

/// Toile's own.
std::string toile_version();

/// The answer to --version, on stdout.
void print_version(const std::string& name);

/// Metres, by the names of units of length.
const std::map<std::string, double>& length_units();

/// A length with its unit ("10mm", "1.5cm", "0.01m"), in metres. Throws UsageError, naming
/// `option`, when it is not a positive length, or a bare number: whoever writes 25 means
/// millimetres or inches.
double parse_length(const std::string& text, const std::string& option);

/// The same of a time ("1s", "500ms"; a bare number is seconds), in seconds.
double parse_time(const std::string& text, const std::string& option);

/// The same of memory ("4GB", "500MB"), in bytes.
std::uint64_t parse_memory(const std::string& text, const std::string& option);

}  // namespace toile
