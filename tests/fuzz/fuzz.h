// Feeds a reader with damaged files for a time. A crash, a hang and a sanitizer's finding end it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace toile::fuzz {

/// A file that is there as long as this: for what reads files by their names only.
struct ScratchFile {
  ScratchFile(std::filesystem::path where, const std::string& text);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  std::filesystem::path path;
};

/// What a text is tried on. It may throw Error and nothing else.
using Target = std::function<void(const std::string&)>;

/// Runs `target` on the files of `seeds`, damaged at random, for as long as the command line says:
/// PROGRAM [SECONDS [SEED]], 5 and 1 by default. `words` are of the format: one takes the place of
/// another part now and then. Each input is written to PROGRAM.input before it is tried, and
/// removed at the end. Returns an exit code.
int run(int argc, char** argv, const std::vector<std::filesystem::path>& seeds,
        const std::vector<std::string>& words, const Target& target);

}  // namespace toile::fuzz
