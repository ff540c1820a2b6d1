// Writes files whole or not at all, and reads whole files.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace toile {

/// Writes to a temporary file beside `path`. commit() renames it to `path`. A run that is killed or
/// throws before commit() leaves `path` as it was. Throws Error when the folder can't be written or
/// the disk is full.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::ostream& stream() { return stream_; }
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::ofstream stream_;
};

/// Writes `content` to `path`, whole or not at all. Throws Error as OutputFile does.
void write_file(const std::filesystem::path& path, std::string_view content);

/// Throws Error unless a file can be written there. Call it before a long computation.
void check_writable(const std::filesystem::path& path);

/// Throws Error unless the path ends in one of the extensions, such as ".obj", in small or capital
/// letters. A file should have the format that its name says.
void check_extension(const std::filesystem::path& path, const std::vector<std::string>& extensions);

/// The content of a file. Throws Error when it is missing, a folder, or can't be read.
std::string read_file(const std::filesystem::path& path);

}  // namespace toile
