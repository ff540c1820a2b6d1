// What can be seen of a dressing while it runs: a progress bar, and the states on the way.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "cloth/judge/frame.h"

namespace toile {

/// Drives a progress bar on stderr, which is full at the end of the scope, and writes the states as
/// OBJ files into a folder.
class DressWatch {
 public:
  /// Throws Error when the folder can't be made.
  DressWatch(std::optional<std::filesystem::path> folder, bool show_progress);
  ~DressWatch();
  DressWatch(const DressWatch&) = delete;
  DressWatch& operator=(const DressWatch&) = delete;

  void operator()(const DressFrame& frame);

 private:
  struct Bar;
  std::optional<std::filesystem::path> folder_;
  std::unique_ptr<Bar> bar_;
  int count_ = 0;
};

}  // namespace toile
