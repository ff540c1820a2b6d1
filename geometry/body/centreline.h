// Following a limb or the torso from section to section.
#pragma once

#include <optional>
#include <vector>

#include "geometry/slice.h"

namespace toile {

/// A section met on the way along a limb.
struct Station {
  double along = 0;  ///< way from the first station, metres; for a level walk the height y
  Vec3 direction;    ///< unit normal of the cutting plane, onward
  Section section;
};

/// Whether the point lies within a closed section of a plane of that normal.
bool contains(const Section& section, const Vec3& point, const Vec3& normal);

/// Of `sections` with at least `min_area`, the smallest that contains `point`; if none does, the
/// one whose centroid is nearest to it, at most `reach` away. None: nothing.
std::optional<Section> section_at(const std::vector<Section>& sections, const Vec3& point,
                                  const Vec3& normal, double min_area, double reach);

struct WalkOptions {
  double step = 0;      ///< between sections, metres
  double min_area = 0;  ///< m^2; ends where the section is smaller
  double reach = 0;     ///< the next centroid is at most so far from where it is expected
  double length = 0;    ///< ends after this way
};

/// Walks along a limb from its section at `start` (inside the limb), each next plane square to the
/// way of the last sections, until the limb ends. Empty where no section is at the start.
std::vector<Station> walk_limb(const TriangleMesh& mesh, const Vec3& start, const Vec3& direction,
                               const WalkOptions& options);

/// As walk_limb with level planes, from y = start.y() towards y = `end`. `along` is y.
std::vector<Station> walk_level(const TriangleMesh& mesh, const Vec3& start, double end,
                                const WalkOptions& options);

/// The point of the centreline at `along`, between stations linearly; beyond the ends the end's.
Vec3 point_along(const std::vector<Station>& stations, double along);

}  // namespace toile
