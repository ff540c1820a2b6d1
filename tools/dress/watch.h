// What can be seen of a dressing while it runs: a progress bar, and the states on the way.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "cloth/dressing/dress.h"
#include "cloth/judge/certify.h"

namespace toile {

/// Drives a progress bar on stderr, writes the states as OBJ files into a folder, has them checked.
/// All end with the scope.
class DressWatch {
 public:
  /// `certificate` null: nothing is checked. Throws Error when the folder can't be made.
  DressWatch(std::optional<std::filesystem::path> folder, bool show_progress,
             Certificate* certificate);
  ~DressWatch();
  DressWatch(const DressWatch&) = delete;
  DressWatch& operator=(const DressWatch&) = delete;

  void operator()(const DressFrame& frame);

 private:
  struct Bar;
  std::optional<std::filesystem::path> folder_;
  std::unique_ptr<Bar> bar_;
  Certificate* certificate_;
  int count_ = 0;
};

}  // namespace toile
