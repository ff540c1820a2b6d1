#include "io/output_file.h"

#include <unistd.h>

#include <boost/algorithm/string/predicate.hpp>
#include <system_error>

#include "geometry/error.h"

namespace toile {

namespace fs = std::filesystem;

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
  if (fs::is_directory(path_)) throw Error(path_.string(), "is a folder", "name a file");
  // The process id keeps the temporary files of two runs apart that write the same file.
  temporary_ = path_;
  temporary_ += ".part" + std::to_string(getpid());
  stream_.open(temporary_, std::ios::binary | std::ios::trunc);
  if (!stream_) {
    throw Error(path_.string(), "can't be written",
                "check that its folder exists and that you may write there");
  }
}

OutputFile::~OutputFile() {
  if (temporary_.empty()) return;
  stream_.close();
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void OutputFile::commit() {
  stream_.close();
  if (!stream_) throw Error(path_.string(), "could not be written whole", "is the disk full?");
  std::error_code failed;
  fs::rename(temporary_, path_, failed);
  if (failed) throw Error(path_.string(), "could not be put in place", failed.message());
  temporary_.clear();
}

void write_file(const fs::path& path, std::string_view content) {
  OutputFile file(path);
  file.stream().write(content.data(), static_cast<std::streamsize>(content.size()));
  file.commit();
}

void check_writable(const fs::path& path) { const OutputFile probe(path); }

void check_extension(const fs::path& path, const std::vector<std::string>& extensions) {
  for (const std::string& extension : extensions) {
    if (boost::algorithm::iequals(path.extension().string(), extension)) return;
  }
  const std::string& usual = extensions.front();
  throw Error(path.string(), "is not named " + usual + ", which is what would be written",
              "name it " + fs::path(path.filename()).replace_extension(usual).string());
}

std::string read_file(const fs::path& path) {
  std::error_code failed;
  if (fs::is_directory(path, failed)) throw Error(path.string(), "is a folder", "name a file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Error(path.string(), "can't be read", "does the file exist?");
  std::string content((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (stream.bad()) throw Error(path.string(), "could not be read to its end", "");
  return content;
}

}  // namespace toile
