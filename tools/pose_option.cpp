#include "tools/pose_option.h"

#include "io/pose_file.h"
#include "tools/program.h"

namespace toile {

bool is_pose_file(const std::string& given) {
  return given.find_first_of("./") != std::string::npos;
}

Pose pose_of(const std::string& given, PosedFigure figure) {
  if (given == "standing") return standing_pose();
  if (given == "walking") return walking_pose();
  const bool of_body = figure == PosedFigure::body;
  if (of_body && given == "sitting") return sitting_pose();
  if (of_body && given == "reaching") return reaching_pose();
  if (!is_pose_file(given)) {
    throw UsageError("--pose", "'" + given + "' is no pose",
                     of_body ? "give standing, walking, sitting, reaching or a file"
                             : "give standing, walking or a file");
  }
  return read_pose(given, figure);
}

}  // namespace toile
