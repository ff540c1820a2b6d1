#include "tools/batch/files.h"

#include "geometry/error.h"

namespace toile {

void remove_files(const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& file : files) {
    std::error_code failed;
    std::filesystem::remove(file, failed);
    if (failed) throw Error(file.string(), "can't be replaced", failed.message());
  }
}

}  // namespace toile
