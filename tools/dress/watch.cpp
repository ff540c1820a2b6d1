#include "tools/dress/watch.h"

#include <boost/timer/progress_display.hpp>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "geometry/error.h"
#include "pattern/garment_file.h"

namespace toile {

namespace fs = std::filesystem;

struct DressWatch::Bar {
  boost::timer::progress_display display{100, std::cerr, "", "", ""};

  void reach(unsigned long percent) {
    if (percent > display.count()) display += percent - display.count();
  }
};

DressWatch::DressWatch(std::optional<fs::path> folder, bool show_progress)
    : folder_(std::move(folder)) {
  if (folder_) {
    std::error_code failed;
    fs::create_directories(*folder_, failed);
    if (failed) throw Error(folder_->string(), "can't hold frames", failed.message());
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
