// Binary glTF 2.0 files (.glb): meshes that 3D programs, game engines and browsers read.
#pragma once

#include <string>
#include <vector>

#include "geometry/types.h"
#include "io/view/colour.h"

namespace toile {

/// A dull surface, seen from both sides.
struct GltfMaterial {
  std::string name;
  Colour colour{1, 1, 1};  ///< vertex colours are multiplied with it
};

/// A mesh and the object of the same name that shows it.
struct GltfMesh {
  std::string name;
  int material = 0;                 ///< index into GltfScene::materials
  std::vector<Vec3> points;         ///< metres, y up and the front at +z, which are glTF's axes
  std::vector<Vec3> normals;        ///< unit length, one a point
  std::vector<Triangle> triangles;  ///< of points, at least one
  /// Maps with one place a point, v counted upward as in OBJ. glTF counts v downward from the top:
  /// the file holds 1 - v, and programs that count upward show v again.
  std::vector<std::vector<Vec2>> maps;
  std::vector<Colour> colours;  ///< one a point, or none; the file holds linear light, as glTF asks
};

struct GltfScene {
  std::string generator;  ///< the program that writes it
  std::string colours;    ///< what vertex colours say, for people; empty: nothing
  std::vector<GltfMaterial> materials;
  std::vector<GltfMesh> meshes;
};

/// The bytes of the file. Coordinates are floats in it. Throws Error beyond 4 GiB, which the format
/// can't hold.
std::string format_glb(const GltfScene& scene);

}  // namespace toile
