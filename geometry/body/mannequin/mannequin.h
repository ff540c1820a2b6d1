// The project's own body: a mannequin made to a woman's measures.
#pragma once

#include <string>
#include <vector>

#include "geometry/body/pose.h"
#include "geometry/body/skeleton.h"
#include "geometry/types.h"

namespace toile {

struct MannequinOptions {
  double edge_length = 0.009;  ///< metres; about the mean edge; 4 mm to 15 mm
  Pose pose = standing_pose();
};

/// A girth as measured on the finished mesh.
struct MannequinGirth {
  std::string name;     ///< neck, bust, waist, abdomen, hip, upper arm, elbow, wrist,
                        ///< upper thigh, mid-thigh, knee, calf, ankle
  Vec3 centre;          ///< a point that the tape goes around; limbs: of the left one
  Vec3 normal;          ///< of the plane that the tape lies in
  double target = 0;    ///< metres
  double measured = 0;  ///< metres
};

struct Mannequin {
  TriangleMesh surface;
  std::vector<MannequinGirth> girths;
  Skeleton skeleton;
};

/// Makes the mannequin: closed, 2-manifold, outward, about 1.70 m tall, standing on y = 0 and
/// facing +z, left +x, arms out at 45 degrees. Tailoring cross-sections are lofted, joined smoothly
/// and scaled until the girths are the targets': bust to knee those of Zhong & Xu 2009, Fig. 12.
///
/// Posed otherwise, its parts turn about their joints, and limbs bend at knee, elbow and ball of
/// the foot along an arc that their cross-sections follow; then they are joined as before. Girths
/// are taken square to the posed limbs and are what they were but for the upper thigh, where the
/// trunk flows in. The lowest point is at y = 0. The trunk stays upright.
///
/// The time goes with 1 / edge_length^3. The same options give the same bits. Throws Error for an
/// edge length outside 4 mm to 15 mm, as check_pose, and where the pose makes parts touch.
Mannequin make_mannequin(const MannequinOptions& options = {});

/// The girth of the section of `surface` around `centre`, square to `normal`: of its closed
/// outlines the one whose middle is nearest to `centre`. Metres. Throws Error when the plane meets
/// nothing.
double girth_around(const TriangleMesh& surface, const Vec3& centre, const Vec3& normal);

}  // namespace toile
