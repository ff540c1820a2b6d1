// Garments on bodies, dressed as `dress` does.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "cloth/scene/collider.h"
#include "geometry/body/skeleton.h"
#include "tests/benchmarks/prepare.h"
#include "tests/benchmarks/work_precision/case.h"

namespace toile::precision {

/// A body that is worn by, as the programs have cleaned it.
struct Wearer {
  explicit Wearer(const std::filesystem::path& body);
  Collider collider;
  Skeleton skeleton;
};

/// A garment that the benchmark knows.
struct WornGarment {
  std::string scene;
  std::string pattern;  ///< of the samples, or of the real data
  std::string body;     ///< standing or mean_all
};

inline const WornGarment tshirt = {"sample T-shirt", "tshirt.json", "standing"};
inline const WornGarment gathered_skirt = {"sample gathered skirt", "gathered_skirt.json",
                                           "standing"};
inline const WornGarment elastic_skirt = {"sample elastic skirt", "elastic_skirt.json", "standing"};
inline const WornGarment shirt = {"GarmentCode shirt", "patterns/garmentcode/shirt_mean.json",
                                  "mean_all"};
inline const WornGarment pencil_dress = {"GarmentCode pencil dress",
                                         "patterns/garmentcode/dress_pencil.json", "mean_all"};

/// The term that a scene leaves out, to show what it costs and buys. The strain limit, which scenes
/// do not have, is put in instead.
enum class Switched { none, bending, self_contact, edge_contact, friction, strain_limit };

/// Makes bodies and meshes once each, by the programs.
class Wardrobe {
 public:
  Wardrobe();
  ~Wardrobe();
  /// Nothing where its data is absent. The wardrobe has to outlive it.
  std::unique_ptr<Case> get(const WornGarment& garment, double edge_mm,
                            Switched term = Switched::none);

 private:
  struct Shelf;
  std::unique_ptr<Shelf> shelf_;
};

}  // namespace toile::precision
