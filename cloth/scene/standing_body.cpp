#include "cloth/scene/standing_body.h"

namespace toile {

Scene standing_scene(const Scene& scene) {
  if (scene.standing == nullptr) return scene;
  Scene standing = scene;
  standing.collider = &scene.standing->collider;
  standing.skeleton = &scene.standing->skeleton;
  standing.standing = nullptr;
  return standing;
}

}  // namespace toile
