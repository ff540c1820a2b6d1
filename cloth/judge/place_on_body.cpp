#include "cloth/judge/place_on_body.h"

#include <algorithm>

#include "cloth/judge/constants.h"
#include "geometry/body/bones.h"
#include "geometry/body/flaws.h"
#include "io/text.h"

namespace toile {

std::string in_words(BodyPart part) {
  std::string words = name_of(part);
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string place_on_body(const Vec3& point, const Skeleton& skeleton) {
  const double height = point.y();
  if (height < 0) return "below the floor by " + centimetres(-height, 0);
  const BodyPart part = part_near(skeleton, point);
  std::string name = in_words(part);
  const double waist = skeleton.joint("waist").y();
  if (part == BodyPart::torso) {
    const double crotch = skeleton.joint("pelvis").y();
    const double armpit = skeleton.joint("chest").y();
    name = height < crotch                   ? "thighs"
           : height < 0.5 * (crotch + waist) ? "hips"
           : height < 0.5 * (waist + armpit) ? "waist"
           : height < armpit                 ? "chest"
                                             : "shoulders";
  } else if (is_leg(part)) {
    name = height < skeleton.joint("left_knee").y() ? "shins"
           : height < skeleton.joint("pelvis").y()  ? "thighs"
                                                    : "hips";
  }
  if (Bones(skeleton, part).distance(point) > beside_body) name = "beside the body";
  return name + ", " + centimetres(height, 0) + " above the floor";
}

}  // namespace toile
