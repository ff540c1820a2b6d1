// The project's sample body: a mannequin made to a woman's measures.
#pragma once

#include <string>
#include <vector>

#include "geometry/body/mannequin/mannequin_shape.h"
#include "geometry/body/pose.h"
#include "geometry/body/skeleton.h"
#include "geometry/types.h"

namespace toile {

struct MannequinOptions {
  double edge_length = 0.009;  ///< metres, about the mean edge; 0.004 to 0.015
  Pose pose = standing_pose();
  std::string pose_name = "pose";  ///< the pose's file, for messages
};

/// Whether a closed surface is one piece without a hole through it, by Euler's formula.
bool is_one_sphere(const TriangleMesh& mesh);

/// A girth measured on the finished mesh.
struct MannequinGirth {
  std::string name;     ///< neck, bust, waist, abdomen, hip, upper arm, elbow, wrist,
                        ///< upper thigh, mid-thigh, knee, calf, ankle
  Vec3 centre;          ///< metres: a point that the tape goes around; of the left limb
  Vec3 normal;          ///< of the tape's plane
  double target = 0;    ///< metres
  double measured = 0;  ///< metres
};

struct Mannequin {
  TriangleMesh surface;
  std::vector<MannequinGirth> girths;
  Skeleton skeleton;
};

/// Makes the mannequin: closed, 2-manifold, outward-oriented, about 1.70 m tall. It stands on y = 0
/// and faces +z, with left +x and arms out at 45 degrees. Tailoring cross-sections are lofted,
/// joined smoothly and scaled to the target girths. Those from bust to knee are from [Zhong & Xu
/// 2009, Fig. 12].
///
/// In another pose the parts turn about their joints. Limbs bend at knee, elbow and ball of the
/// foot along an arc that their cross-sections follow. Then they are joined as at rest. Girths are
/// measured square to the posed limbs. They stay as they were, except the upper thigh, where the
/// trunk flows in. The lowest point is at y = 0. The trunk stays upright.
///
/// The cost is proportional to 1 / edge_length^3. The same options give the same bits. It throws
/// Error for an edge length outside 4 mm to 15 mm, as check_pose() does, and where the pose makes
/// parts touch.
Mannequin make_mannequin(const MannequinOptions& options = {});

/// The mesh of a shape, as make_mannequin() describes it. The girths' targets are those of the
/// shape. Throws as make_mannequin() does.
Mannequin mesh_mannequin(const MannequinShape& shape, const MannequinOptions& options);

/// Metres: the girth of the section of `surface` with the plane through `centre` square to
/// `normal`. Of several outlines it measures the one whose centroid is closest to `centre`. It
/// throws Error when the plane does not meet the surface. It costs a slice().
double girth_around(const TriangleMesh& surface, const Vec3& centre, const Vec3& normal);

}  // namespace toile
