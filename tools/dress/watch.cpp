#include "tools/dress/watch.h"

#include <boost/timer/progress_display.hpp>
#include <iomanip>
#include <iostream>
#include <regex>
#include <sstream>

#include "geometry/error.h"
#include "pattern/file/garment_file.h"

namespace toile {

namespace fs = std::filesystem;

struct DressWatch::Bar {
  boost::timer::progress_display display{100, std::cerr, "", "", ""};

  void reach(unsigned long percent) {
    if (percent > display.count()) display += percent - display.count();
  }
};

namespace {

/// A shorter run would leave the last frames of a longer one.
void remove_earlier_frames(const fs::path& folder) {
  static const std::regex frame("[0-9]{4,}-[a-z_]+\\.obj");
  std::vector<fs::path> earlier;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (std::regex_match(entry.path().filename().string(), frame)) earlier.push_back(entry.path());
  }
  for (const fs::path& file : earlier) fs::remove(file);
}

}  // namespace

DressWatch::DressWatch(std::optional<fs::path> folder, bool show_progress)
    : folder_(std::move(folder)) {
  if (folder_) {
    std::error_code failed;
    fs::create_directories(*folder_, failed);
    if (failed) throw Error(folder_->string(), "can't hold frames", failed.message());
    remove_earlier_frames(*folder_);
  }
  if (show_progress) bar_ = std::make_unique<Bar>();
}

DressWatch::~DressWatch() {
  if (bar_) bar_->reach(100);
}

void DressWatch::operator()(const DressFrame& frame) {
  if (bar_) bar_->reach(static_cast<unsigned long>(100 * frame.progress));
  if (!folder_) return;
  std::ostringstream name;
  name << std::setw(4) << std::setfill('0') << count_++ << '-' << frame.stage << ".obj";
  write_dressed(*folder_ / name.str(), as_dressed(frame.mesh, frame.points, frame.mesh.triangles));
}

}  // namespace toile
