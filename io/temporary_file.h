// Files that exist only until they are put in place, and are removed when the program is killed.
#pragma once

#include <cstddef>
#include <filesystem>

namespace toile {

/// The name of a file beside `path`. The file is the caller's to make. It is removed at the end of
/// the scope, unless put_in_place() was called.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& path);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& name() const { return name_; }
  /// Renames the file to `path`. Throws Error when that is not possible.
  void put_in_place(const std::filesystem::path& path);

 private:
  std::filesystem::path name_;
  std::size_t slot_;
};

/// From here on, a signal that ends the program removes all temporary files first: hang-up,
/// interrupt, termination, a broken pipe, no more time. It then ends the program as always: a shell
/// sees exit code 130 or 143. Signals that were ignored stay ignored.
void remove_temporary_files_on_signals();

/// While one lives, such signals wait: so all files of a set are put in place, or none.
class SignalsWait {
 public:
  SignalsWait();
  ~SignalsWait();
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;
};

}  // namespace toile
