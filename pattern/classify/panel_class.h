// What a panel is: plain data. classify.h makes it, and every room reads it here.
#pragma once

#include <cstdint>
#include <string>

#include "geometry/body/body_part.h"

namespace toile {

/// What a panel is a piece of.
enum class PanelRole : std::uint8_t {
  unknown,
  bodice,
  skirt,
  trousers,
  sleeve,
  cuff,
  collar,
  hood,
  waistband,
  yoke,
  facing,
  pocket,
};

/// The wearer's. The numbers are signs to count with.
enum class PanelSide : std::int8_t { right = -1, none = 0, left = 1 };
enum class PanelFace : std::int8_t { back = -1, none = 0, front = 1 };

/// Who says it. Name, label and what the pattern states are witnesses. Where two of them contradict
/// each other, the panel's seams and its shape decide.
enum class PanelSource : std::uint8_t {
  none,    ///< nobody
  stated,  ///< the pattern, by the panel's placement
  label,   ///< GarmentCode's `body`, `arm` or `leg`
  name,    ///< the panel's name
  seams,   ///< what it is sewn to
  shape,   ///< that of another panel, which is the same or its mirror image
  asked,   ///< the user, who beats them all
};

/// An answer and who gave it.
template <typename Answer>
struct Told {
  Answer is{};
  PanelSource by = PanelSource::none;

  operator Answer() const { return is; }  // NOLINT(google-explicit-constructor): it is the answer
  bool operator==(const Told&) const = default;
};

/// What a panel is. Where nobody tells, an answer is its enum's `unknown` or `none`.
struct PanelClass {
  Told<BodyPart> part;  ///< the body part that it is for
  /// What it is a piece of. What is sewn onto a piece is named before the piece: a sleeve's cuff is
  /// a cuff.
  Told<PanelRole> role;
  /// What it is worn with, which tells the place on the body; no other role stands here. `sleeve`
  /// goes around an arm, and `trousers` around each leg. `skirt` hangs from waist or hips around
  /// both legs. `waistband` holds one of the two. `bodice` hangs from the shoulders or the chest.
  /// A cuff is worn with its sleeve or leg; collar, hood and yoke are worn with the bodice.
  Told<PanelRole> worn_as;
  Told<PanelSide> side;
  Told<PanelFace> face;
  Told<bool> around;  ///< it closes around its part by itself, as a sleeve of one piece does
  /// What the witnesses say against each other, such as "its name says right, but the pattern
  /// states the part 'left_arm'". Empty: they agree.
  std::string contradiction;

  /// Whether it is a hood's or a collar's, or is stated to be for the head.
  bool is_headwear() const {
    return part == BodyPart::head || role == PanelRole::hood || role == PanelRole::collar;
  }
  bool operator==(const PanelClass&) const = default;
};

inline int side_sign(const PanelClass& is) { return static_cast<int>(is.side.is); }
inline int face_sign(const PanelClass& is) { return static_cast<int>(is.face.is); }

/// "sleeve"; empty: unknown.
std::string name_of(PanelRole role);

/// "sleeve, left, by name": what it is, and who says so. Empty: nobody says anything.
std::string text_of(const PanelClass& is);

}  // namespace toile
