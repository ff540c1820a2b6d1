// Writes files whole or not at all, and reads whole files.
#pragma once

#include <concepts>
#include <filesystem>
#include <list>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

#include "io/temporary_file.h"

namespace toile {

/// What a stream writes by, to a file that is open.
class DescriptorBuffer : public std::streambuf {
 public:
  explicit DescriptorBuffer(int descriptor);

 protected:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override;

 private:
  bool write(const char* text, std::size_t size) const;

  int descriptor_;
  std::vector<char> waiting_;
};

/// Writes to a temporary file beside `path`. commit() renames it to `path`. A run that is killed or
/// throws before commit() leaves `path` as it was. A symbolic link stays, the file that it points
/// to is replaced.
///
/// Throws Error when the file or its folder can't be written or the disk is full. A folder is an
/// Error. So is a device, a pipe or a socket, /dev/stdout and /dev/null among them: what is written
/// there can't be taken back.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  std::ostream& stream() { return stream_; }
  /// Ends the writing. Throws Error unless all was written.
  void finish();
  /// finish(), and the file is in its place.
  void commit();
  /// Where the content is until commit().
  const std::filesystem::path& temporary() const { return temporary_.name(); }

 private:
  std::filesystem::path path_;
  std::filesystem::path target_;  // path_, or what it is a link to
  TemporaryFile temporary_;
  DescriptorBuffer buffer_;
  std::ostream stream_;
};

class OutputFiles;

/// Where a file is written: at its path, or as one of a set.
class OutputPath {
 public:
  template <std::convertible_to<std::filesystem::path> Path>
  OutputPath(const Path& path) : path_(path) {}
  OutputPath(std::filesystem::path path, OutputFiles& files)
      : path_(std::move(path)), files_(&files) {}

  const std::filesystem::path& path() const { return path_; }
  OutputFiles* files() const { return files_; }  ///< null: the file is written alone

 private:
  std::filesystem::path path_;
  OutputFiles* files_ = nullptr;
};

/// Files that belong together: all are written to temporary files, then all are put in place. What
/// fails or is killed before commit() leaves every path as it was. commit() is not interrupted by a
/// signal. Only a folder that is changed meanwhile can make it put in place some and not all.
class OutputFiles {
 public:
  /// A file of this set.
  OutputPath at(const std::filesystem::path& path) { return {path, *this}; }
  /// Takes a file's content. The last for a path counts. Throws Error as OutputFile does.
  void add(const std::filesystem::path& path, std::string_view content);
  /// The temporary file that holds what was written for `path`.
  const std::filesystem::path& written(const std::filesystem::path& path) const;
  void commit();

 private:
  std::list<OutputFile> files_;
};

/// Writes `content`, whole or not at all; as one of a set, to be put in place with the others.
/// Throws Error as OutputFile does.
void write_file(const OutputPath& path, std::string_view content);

/// Throws Error unless a file can be written there. Call it before a long computation.
void check_writable(const std::filesystem::path& path);

/// Whether two paths name one file, by links of both kinds too. Names that differ in capitals alone
/// count as one, as they are on some disks. Neither file has to exist.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Throws Error unless the path ends in one of the extensions, such as ".obj", in small or capital
/// letters. A file should have the format that its name says.
void check_extension(const std::filesystem::path& path, const std::vector<std::string>& extensions);

/// The content of a file. Throws Error when it is missing, a folder, or can't be read.
std::string read_file(const std::filesystem::path& path);

}  // namespace toile
