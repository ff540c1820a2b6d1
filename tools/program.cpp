#include "tools/program.h"

#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <iostream>
#include <map>

#include "io/output_file.h"
#include "io/temporary_file.h"
#include "io/text.h"

namespace toile {

namespace po = boost::program_options;

void CommonSettings::say(const std::string& line) const {
  if (!quiet) std::cerr << line << '\n';
}

namespace {

std::atomic<bool> is_program = false;  // not the library, within another program

/// Refuses files that would be lost or can't be written, before any work.
void check_files(const CommandLineProgram& program, const CommonSettings& settings,
                 ProgramFiles files) {
  if (settings.report) files.writes.push_back(*settings.report);
  refuse_overwriting(files);
  if (program.writes_folder) {
    std::error_code failed;
    std::filesystem::create_directories(settings.output, failed);
    if (failed) throw Error(settings.output.string(), "can't be made", failed.message());
  }
  for (const std::filesystem::path& file : files.writes) check_writable(file);
}

int usage_error(const CommandLineProgram& program, const std::string& problem) {
  std::cerr << program.name << ": " << problem << "\nusage: " << program.name << ' '
            << program.usage << "\n       " << program.name << " --help\n";
  return exit_usage;
}

/// What the command line lacks, by the name that it would be given by.
std::string missing(const CommandLineProgram& program, const po::required_option& wrong) {
  std::string name = wrong.get_option_name();
  name.erase(0, name.find_first_not_of('-'));
  const bool is_argument =
      program.positional.max_total_count() > 0 && program.positional.name_for_position(0) == name;
  return (is_argument ? "the " : "--") + name + " is missing";
}

/// A positive number with one of the units.
double parse_quantity(const std::string& text, const std::map<std::string, double>& units,
                      const std::string& option, const std::string& what,
                      const std::string& such_as) {
  std::size_t used = 0;
  double value = 0;
  try {
    value = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  const auto unit = units.find(text.substr(used));
  if (used == 0 || unit == units.end() || !std::isfinite(value) || value <= 0) {
    throw UsageError(option, "'" + text + "' is not " + what,
                     "give a positive number with " + such_as);
  }
  return value * unit->second;
}

/// What is wrong with more arguments than the program takes. It names the first that is too many.
std::string too_many(int argc, char** argv, const po::options_description& options,
                     const CommandLineProgram& program) {
  const unsigned taken = program.positional.max_total_count();
  po::positional_options_description any;
  any.add("argument", -1);
  const auto parsed = po::command_line_parser(argc, argv).options(options).positional(any).run();
  std::string extra;
  for (const po::option& option : parsed.options) {
    if (option.position_key == static_cast<int>(taken)) extra = option.original_tokens.front();
  }
  return (taken == 0 ? "takes no arguments but options"
                     : "takes one " + program.positional.name_for_position(0)) +
         "; '" + shown_text(extra) + "' is too many";
}

}  // namespace

void CommonSettings::warn(const std::string& line) {
  if (is_program) std::cerr << "warning: " << line << '\n';
}

po::options_description common_options(const CommandLineProgram& program) {
  po::options_description common("Every program's options");
  common.add_options()("output,o", po::value<std::string>(),
                       program.writes_folder ? "the folder to write to" : "the file to write");
  if (!program.writes_folder) {
    common.add_options()("report", po::value<std::string>(),
                         "write what was done and measured, as JSON");
  }
  common.add_options()("threads", po::value<int>()->default_value(0),
                       "threads to use, 0 for all; the result is the same for any number")(
      "quiet,q", po::bool_switch(), "say nothing but warnings and errors")("help,h", "this text")(
      "version", "the version");
  return common;
}

int run_program(int argc, char** argv, const CommandLineProgram& program) {
  is_program = true;
  // A file that grows beyond the shell's limit is an error like a full disk, not a signal.
  std::signal(SIGXFSZ, SIG_IGN);
  remove_temporary_files_on_signals();
  po::options_description all;
  const po::options_description common = common_options(program);
  all.add(program.options).add(common);
  po::variables_map given;
  CommonSettings settings;
  settings.program = program.name;
  try {
    po::store(po::command_line_parser(argc, argv).options(all).positional(program.positional).run(),
              given);
    if (given.count("help") != 0) {
      // Positional arguments stand in the usage line, not in the list of options.
      std::cout << program.name << ": " << program.summary << "\n\nusage: " << program.name << ' '
                << program.usage << "\n\n"
                << program.options << '\n'
                << common;
      if (!program.footer.empty()) std::cout << '\n' << program.footer << '\n';
      return exit_done;
    }
    if (given.count("version") != 0) {
      print_version(program.name);
      return exit_done;
    }
    po::notify(given);
    if (program.check) program.check(given);
    const auto is_given = [&](const std::string& option) { return given.count(option) != 0; };
    if (is_given("output")) {
      settings.output = given["output"].as<std::string>();
    } else if (std::ranges::none_of(program.instead_of_output, is_given)) {
      return usage_error(program,
                         program.writes_folder ? "-o FOLDER is missing" : "-o FILE is missing");
    }
    if (given.count("report") != 0) settings.report = given["report"].as<std::string>();
    settings.threads = given["threads"].as<int>();
    settings.quiet = given["quiet"].as<bool>();
    if (settings.threads < 0) return usage_error(program, "--threads is negative");
  } catch (const po::required_option& wrong) {
    return usage_error(program, missing(program, wrong));
  } catch (const po::too_many_positional_options_error&) {
    return usage_error(program, too_many(argc, argv, all, program));
  } catch (const po::error& wrong) {
    return usage_error(program, wrong.what());
  } catch (const UsageError& wrong) {
    return usage_error(program, wrong.what());
  }

  std::optional<tbb::global_control> limit;
  if (settings.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism,
                  static_cast<std::size_t>(settings.threads));
  }
  try {
    if (!program.output_extensions.empty() && given.count("output") != 0) {
      check_extension(settings.output, program.output_extensions);
    }
    const Job job = program.prepare(given, settings);
    check_files(program, settings, job.files);
    return job.work();
  } catch (const std::bad_alloc&) {
    std::cerr << program.name << ": error: out of memory; use a coarser mesh\n";
  } catch (const UsageError& wrong) {
    std::cerr << program.name << ": error: " << wrong.what() << '\n';
    return exit_usage;
  } catch (const Error& failed) {
    std::cerr << program.name << ": error: " << failed.what() << '\n';
  } catch (const std::filesystem::filesystem_error& failed) {
    std::cerr << program.name << ": error: " << failed.path1().string() << ": can't be reached ("
              << failed.code().message() << "); name another file\n";
  } catch (const std::exception&) {
    // A library's own words would tell a user nothing.
    std::cerr << program.name << ": error: the input leads to a case that was not foreseen; "
              << "report it together with the input\n";
  }
  return exit_error;
}

std::string toile_version() { return TOILE_VERSION; }

void print_version(const std::string& name) {
  std::cout << name << " (Toile) " << toile_version() << '\n';
}

const std::map<std::string, double>& length_units() {
  static const std::map<std::string, double> metres = {
      {"m", 1.0}, {"dm", 0.1}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"inch", 0.0254}};
  return metres;
}

double parse_length(const std::string& text, const std::string& option) {
  return parse_quantity(text, length_units(), option, "a length",
                        "m, dm, cm, mm or in, such as 10mm");
}

double parse_time(const std::string& text, const std::string& option) {
  static const std::map<std::string, double> seconds = {{"s", 1.0}, {"ms", 0.001}, {"", 1.0}};
  return parse_quantity(text, seconds, option, "a time", "s or ms, such as 1s");
}

std::uint64_t parse_memory(const std::string& text, const std::string& option) {
  static const std::map<std::string, double> bytes = {
      {"kB", 1e3}, {"MB", 1e6}, {"GB", 1e9}, {"KiB", 0x1p10}, {"MiB", 0x1p20}, {"GiB", 0x1p30}};
  constexpr double max_bytes = 1e18;  // above any machine's
  return static_cast<std::uint64_t>(
      std::min(max_bytes, parse_quantity(text, bytes, option, "an amount of memory",
                                         "kB, MB, GB, KiB, MiB or GiB, such as 4GB")));
}

}  // namespace toile
