// Takes measures one by one and keeps the reason where one can't be taken. For measures.cpp and its
// parts alone.
#pragma once

#include <string>
#include <vector>

#include "geometry/body/limb_landmarks.h"
#include "geometry/body/measures.h"
#include "geometry/slice.h"

namespace toile {

class MeasureTaker {
 public:
  explicit MeasureTaker(const BodyShape& shape) : shape_(shape) {}

  void take_girths();
  void take_arcs();
  void take_limb_girths(int side);
  void take_trunk_lengths();
  void take_side_lengths(int side);
  void take_heights();

  /// All that was taken, lines in the given body's frame.
  std::vector<Measure> taken() const;

 private:
  using Line = std::vector<Vec3>;

  // The parts of take_side_lengths().
  void take_shoulder_lengths(int side);
  void take_bust_lengths(int side);
  void take_shoulder_slopes(int side);
  void take_armscye_lengths(int side);
  void take_neck_to_shoulder(int side);
  void take_across_widths(int side);
  void take_vertical_trunk(int side);
  void take_hip_side_lengths(int side);
  void take_arm_length(int side);

  Line from_bust_to_waist(const Section& upright, const Vec3& apex, const Vec3& waist) const;
  Line around_trunk(const Vec3& shoulder_middle, const Vec3& crotch) const;
  Line hanging_from_waist(int side, const Vec3& waist_side, const Vec3& hip_side,
                          double crotch_height, double y) const;

  /// What a measure needs: landmarks or levels, the first missing one being the reason.
  struct Needs {
    double confidence = 1;
    std::string missing;
  };
  Vec3 point(const std::string& landmark, Needs& needs) const;
  double level(const TrunkLevel& found, const std::string& name, Needs& needs) const;

  void add(const std::string& name, const Needs& needs, double value, std::vector<Line> lines,
           const std::string& definition, const std::string& iso = "");
  void add_angle(const std::string& name, const Needs& needs, double degrees, Line line,
                 const std::string& definition);
  /// The sum of the lines' lengths; none of them may be empty.
  void add_lines(const std::string& name, Needs needs, std::vector<Line> lines,
                 const std::string& definition, const std::string& iso = "");
  void add_height(const std::string& name, const Needs& needs, double low, double high,
                  const Vec3& at, const std::string& definition, const std::string& iso = "");
  /// Around the section that holds `at`, or is nearest to it.
  void add_girth(const std::string& name, Needs needs, const Vec3& at, const Vec3& normal,
                 const std::string& definition, const std::string& iso = "");
  /// The closed tape around the section at `at`; empty where there is none.
  Line girth_line(const Vec3& at, const Vec3& normal) const;
  /// A taut tape on the front (side 1) or back (-1), in the plane of both points that holds z.
  Line over(const Vec3& a, const Vec3& b, double facing) const;
  Line on_skin(const Vec3& a, const Vec3& b) const;
  const Skeleton* skeleton() const {
    return shape_.frame.skeleton ? &*shape_.frame.skeleton : nullptr;
  }

  /// Why there is no such part, an arm or "head"; empty: it is there.
  std::string lack_of(const std::string& part) const;

  const BodyShape& shape_;
  std::vector<Measure> measures_;
};

}  // namespace toile
