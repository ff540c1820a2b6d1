// Sewn panels laid flat, in a front and a back face, so that the edges that are sewn meet.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "pattern/panel_mesh.h"

namespace toile {

/// Panels as they would lie if the sewn garment were pressed flat. The picture shows them from the
/// front: x to the wearer's left, y up, metres. Panels of the front face show their right side
/// there, those of the back face their wrong side.
struct FlatLayout {
  std::vector<int> panels;  ///< indices into PanelMesh::panels
  std::vector<char> back;   ///< per panel of `panels`: whether it lies in the back face
  /// Per panel of `panels`: its place in the picture is turn * flat + at, flat points as complex
  /// numbers. In the back face it is turn * -conj(flat) + at. |turn| = 1.
  std::vector<std::complex<double>> turn;
  std::vector<std::complex<double>> at;
  /// Per panel of `panels`: 0, or how many panels of its face it lies upon, as insets and collars
  /// do.
  std::vector<int> layer;
  double misfit = 0;  ///< m^3: squared gaps of the seams times their lengths, and what it counts as

  /// A flat point of `panels`[i] as its face shows it, before it is turned and moved.
  std::complex<double> shown(std::size_t i, const Vec2& flat) const {
    return {back[i] ? -flat.x() : flat.x(), flat.y()};
  }
  /// Where a flat point of `panels`[i] lies in the picture.
  std::complex<double> place(std::size_t i, const Vec2& flat) const {
    return turn[i] * shown(i, flat) + at[i];
  }
  Vec2 picture(std::size_t i, const Vec2& flat) const {
    const std::complex<double> p = place(i, flat);
    return {p.real(), p.imag()};
  }

  /// Turns the whole picture about its origin, then shifts it.
  void move(std::complex<double> by_turn, std::complex<double> by);
  /// Looks at the picture from behind: the faces change places, and x changes its sign.
  void change_faces();
};

/// Lays `panels`, which seams connect, flat. `is_back` says the face of those that it has one for.
/// The others are chosen: seams should fit, few of them should run around the sides, and panels
/// should not lie upon each other. Up to eleven free panels all choices are tried. More are changed
/// one by one, by pairs, branches and arcs.
///
/// Panels turn and move in the plane until the squared distances of sewn points are least. The
/// longer side of a gathered seam counts as gathered to its middle. The mean direction of drawings'
/// +y is up in the picture. Linear in the seams, times some hundred to thousand layouts.
FlatLayout lay_flat(const PanelMesh& garment, const std::vector<int>& panels,
                    const std::vector<std::optional<bool>>& is_back);

}  // namespace toile
