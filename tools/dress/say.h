// What dress says to people, a line each on stderr.
#pragma once

#include <string>
#include <vector>

#include "cloth/dressing/outfit.h"
#include "tools/program.h"

namespace toile {

/// Says lines as they come, and keeps the warnings for the report.
class DressLog {
 public:
  explicit DressLog(const CommonSettings& common) : common_(common) {}
  void say(const std::string& line) const { common_.say(line); }
  void warn(const Warning& warning);
  /// Those since the last call.
  std::vector<Warning> take_warnings();

 private:
  const CommonSettings& common_;
  std::vector<Warning> warnings_;
};

/// When the dressing became free of intersections; a warning when it did not stay so.
void say_certificate(const Certificate& certificate, DressLog& log);

/// Where panels were placed whose pattern did not tell, and why.
void say_places(const WornLayer& worn, DressLog& log);

/// Where the skeleton positioned the panels, for those that asked for it.
void say_positions(const Placement& placement, DressLog& log);

/// Seams, intersections, strain, wraps and the verdict; warns of what looks wrong.
void say_result(const DressResult& result, const Judgement& judgement, DressLog& log);

/// Which layers press on each other.
void say_pressing(const CoupledResult& coupled, const std::vector<std::string>& names,
                  DressLog& log);

}  // namespace toile
