// A standing figure's bones, arms held out level.
#pragma once

#include <string>

#include "geometry/body/skeleton.h"

namespace toile::test {

/// A standing figure, arms held out level.
inline Skeleton figure() {
  Skeleton s;
  s.joints = {{"pelvis", {0, 0.8, 0}},
              {"waist", {0, 1.0, 0}},
              {"chest", {0, 1.2, 0}},
              {"neck", {0, 1.4, 0}},
              {"head", {0, 1.7, 0}},
              {"left_shoulder", {0.15, 1.3, 0}},
              {"left_elbow", {0.45, 1.3, 0}},
              {"left_wrist", {0.70, 1.3, 0}},
              {"right_shoulder", {-0.15, 1.3, 0}},
              {"right_elbow", {-0.45, 1.3, 0}},
              {"right_wrist", {-0.70, 1.3, 0}},
              {"left_hip", {0.1, 0.85, 0}},
              {"left_knee", {0.1, 0.45, 0}},
              {"left_ankle", {0.1, 0.05, 0}},
              {"right_hip", {-0.1, 0.85, 0}},
              {"right_knee", {-0.1, 0.45, 0}},
              {"right_ankle", {-0.1, 0.05, 0}}};
  s.segments = {{"torso", "pelvis", "waist"},
                {"torso", "waist", "chest"},
                {"torso", "chest", "neck"},
                {"head", "neck", "head"}};
  for (const std::string side : {"left_", "right_"}) {
    s.segments.push_back({side + "arm", side + "shoulder", side + "elbow"});
    s.segments.push_back({side + "arm", side + "elbow", side + "wrist"});
    s.segments.push_back({side + "leg", side + "hip", side + "knee"});
    s.segments.push_back({side + "leg", side + "knee", side + "ankle"});
  }
  return s;
}

}  // namespace toile::test
