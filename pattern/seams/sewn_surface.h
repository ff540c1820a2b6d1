// What the corners and the borders of a garment look like when its seams are sewn.
#pragma once

#include <vector>

#include "pattern/seams/seam_pairs.h"

namespace toile {

/// Per edge: the edge that it is sewn to, the walk of one against the other's; -1: it stays open.
using Partners = std::vector<int>;

/// A place where the border passes from one open edge to the next.
struct BorderStep {
  int from = 0;  ///< open edge
  int to = 0;    ///< open edge
};

/// Follows the outlines over the seams. It keeps what it works with, so one is made for many looks.
class SewnSurface {
 public:
  explicit SewnSurface(const SeamEvidence& evidence);

  /// Adds what is measured of corners that meet, of borders and of the whole. O(edges).
  void measure(const Partners& partners, SeamMeasures& sum);

  /// Of the garment measured last.
  const std::vector<BorderStep>& border() const { return border_; }

 private:
  void measure_inside(SeamMeasures& sum) const;
  void measure_at_border(SeamMeasures& sum) const;
  void measure_borders(SeamMeasures& sum);
  double unlikeness(bool closed) const;
  void measure_fullness(bool closed, SeamMeasures& sum) const;
  double off_junction() const;
  double fullness(int corner, bool leaving) const;
  double shorter(int corner, bool leaving) const;
  bool is_crossing() const;
  bool is_fold() const;
  bool is_filled_slit() const;
  bool is_needless_cut() const;
  double slit_above_here() const;
  double weight_of_point() const;

  int edges_ = 0;
  int panels_ = 0;
  int least_borders_ = 0;  // that a garment of these pieces has
  std::vector<int> next_;
  std::vector<int> previous_;
  std::vector<int> panel_;
  std::vector<double> length_;
  std::vector<double> log_length_;
  std::vector<double> angle_;    // of the corner where the edge starts
  std::vector<double> turning_;  // of the edge
  std::vector<double> rise_;     // of the edge
  std::vector<int> mirror_;
  std::vector<char> turned_over_;  // per panel
  std::vector<int> across_;        // see edge_across()
  std::vector<char> notch_;        // where the edge starts
  std::vector<char> cut_curve_;    // where the edge starts: one curve goes on, cut in two

  const Partners* partners_ = nullptr;
  std::vector<int> corners_;  // that meet, in their order
  std::vector<char> seen_;
  std::vector<int> after_;  // per open edge: the next one on the border
  std::vector<BorderStep> border_;
};

}  // namespace toile
