// A part of a scanned body as a tube about a straight axis, carried on where it was not seen.
#pragma once

#include <vector>

#include "geometry/scan/scan_samples.h"

namespace toile {

/// A straight line inside a part of the body. Metres.
struct TubeAxis {
  Vec3 start{0, 0, 0};
  Vec3 along{0, 1, 0};   ///< of unit length
  double length = 0;     ///< the tube goes on as far
  Vec3 toward{1, 0, 0};  ///< square to `along`, of unit length: angles begin here
};

struct TubeOptions {
  double step = 0.005;   ///< metres between stations and, about, between angles
  double roundness = 1;  ///< of what was not seen: 1 goes on as an arc, 0 as a straight line
  double outside = 0.2;  ///< least cosine of a sample's normal to its direction from the axis
};

/// Radii on a grid of stations along the axis and angles about it. They follow the samples and bend
/// the least, as a thin plate that is a cylinder or flat at rest. So a contour goes on as an arc or
/// a straight line where it was not seen. Along the limb it goes straight on.
class LimbTube {
 public:
  /// `which` are the samples of that part. Those that don't face outward are left out, and so are
  /// those that are far behind others. O(nodes^1.5).
  LimbTube(const TubeAxis& axis, const ScanSamples& samples, const std::vector<int>& which,
           const TubeOptions& options);

  int stations() const { return stations_; }
  int angles() const { return angles_; }
  Vec3 point(int station, int angle) const;  ///< of the wall; any angle, all around
  /// Metres square to the axis from the wall to a point; negative inside. Beyond its ends the tube
  /// goes on as it ends.
  double off(const Vec3& point) const;
  /// Cosine of the angle about the axis from where angles begin to a point.
  double facing(const Vec3& point) const;
  /// Metres: half of the samples are nearer to the wall; infinite without samples.
  double error() const { return error_; }

 private:
  struct Place {
    double station;
    double angle;
    double radius;
  };
  Place place(const Vec3& point) const;
  double radius(int station, int angle) const;
  /// The wall at a place, bilinear between the nodes.
  double wall(const Place& at) const;
  std::vector<double> ordinary_radii(const std::vector<Place>& places) const;
  void fit(const std::vector<Place>& places, const std::vector<double>& areas);

  TubeAxis axis_;
  Vec3 across_;  // square to `along` and `toward`
  TubeOptions options_;
  int stations_;
  int angles_;
  double error_;
  std::vector<double> radii_;
};

}  // namespace toile
