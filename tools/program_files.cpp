#include "tools/program_files.h"

#include "geometry/error.h"
#include "io/output_file.h"

namespace toile {

namespace {

namespace fs = std::filesystem;

void keep_apart(const fs::path& folder, const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    const fs::path holder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (!same_file(file, folder) && !same_file(holder, folder)) continue;
    throw Error(folder.string(), "is filled with files, and " + file.string() + " is there",
                "name a folder for them alone");
  }
}

}  // namespace

void refuse_overwriting(const ProgramFiles& files) {
  std::vector<fs::path> written = files.writes;
  written.insert(written.end(), files.keeps.begin(), files.keeps.end());
  for (std::size_t i = 0; i < written.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!same_file(written[i], written[j])) continue;
      throw Error(written[i].string(), "would be written twice",
                  "give each output a name of its own");
    }
    for (const fs::path& file : files.reads) {
      if (!same_file(written[i], file)) continue;
      throw Error(file.string(), "would be overwritten", "give the output another name");
    }
  }
  for (const fs::path& folder : files.folders) {
    keep_apart(folder, files.reads);
    keep_apart(folder, written);
  }
}

}  // namespace toile
