// Files that exist only until they are put in place, and are removed when the program is killed.
#pragma once

#include <cstddef>
#include <filesystem>

namespace toile {

/// Makes a file for writing and returns its descriptor; -1 where it can't. What is at `name`
/// already stays as it is and makes it fail, a link to nowhere among it.
int make_new_file(const std::filesystem::path& name);

/// A new, empty file beside `path`, with a name that nobody can foresee. It is removed at the end
/// of the scope, unless put_in_place() was called.
class TemporaryFile {
 public:
  /// Does not throw where no file can be made: is_open() tells.
  explicit TemporaryFile(const std::filesystem::path& path);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& name() const { return name_; }
  bool is_open() const { return descriptor_ >= 0; }
  /// What the file is written by, for nobody can lay another file under it.
  int descriptor() const { return descriptor_; }
  /// False where the file's end could not be written. Closing a closed file is well.
  bool close();
  /// Renames the file to `path`. Throws Error when that is not possible.
  void put_in_place(const std::filesystem::path& path);

 private:
  std::filesystem::path name_;
  int descriptor_ = -1;
  std::size_t slot_ = 0;
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
  /// Whether a signal waits. Who lets it wait for long asks, and ends soon.
  static bool has_come();
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;
};

}  // namespace toile
