// A spring of the mass-spring cloth, and which strain counts as its own.
#pragma once

namespace toile {

/// A damped spring between two nodes. It pulls along its axis with
/// stiffness·(length - rest) + damping·(rate of its length).
struct Spring {
  int a = 0;
  int b = 0;
  double rest = 0;       ///< metres, above 0
  double stiffness = 0;  ///< N/m
  double damping = 0;    ///< N·s/m
};

}  // namespace toile
