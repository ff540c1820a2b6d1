// The centreline of a limb or of the trunk, through the centroids of its sections.
#pragma once

#include <optional>
#include <vector>

#include "geometry/slice.h"

namespace toile {

/// One section along a limb.
struct Station {
  double along = 0;  ///< metres from the first station; in a level walk the height y
  Vec3 direction;    ///< unit normal of the cutting plane, ahead
  Section section;
};

/// The smallest of the closed `sections` of `min_area` m^2 or more that contains `point`. If none
/// does, it is the one whose centroid is closest, at most `reach` metres away. Nothing if there is
/// none. `sections` are in falling area, as slice() returns them.
std::optional<Section> section_at(const std::vector<Section>& sections, const Vec3& point,
                                  const Vec3& normal, double min_area, double reach);

struct WalkOptions {
  double step = 0;      ///< metres between sections
  double min_area = 0;  ///< m^2; a walk ends where the section is smaller
  double reach = 0;     ///< metres at most from the expected to the found centroid
  double length = 0;    ///< metres after which a walk ends
};

/// Cuts a limb into sections from the point `start` inside it until the limb ends. Each next plane
/// is square to the path through the last sections. Empty if there is no section at the start. It
/// costs a slice() a station.
std::vector<Station> walk_limb(const TriangleMesh& mesh, const Vec3& start, const Vec3& direction,
                               const WalkOptions& options);

/// Cuts with level planes from y = start.y() towards y = `end`. Station::along is y. It costs a
/// slice() a station.
std::vector<Station> walk_level(const TriangleMesh& mesh, const Vec3& start, double end,
                                const WalkOptions& options);

/// The point of the centreline at `along`, linear between stations. Beyond an end it is the end.
Vec3 point_along(const std::vector<Station>& stations, double along);

}  // namespace toile
