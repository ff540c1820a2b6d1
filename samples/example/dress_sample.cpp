// Dresses the sample mannequin with a pattern by the library alone, and says how it fits.
//   dress_sample PATTERN.json DRESSED.obj
#include <iostream>

#include "cloth/dressing/dress.h"
#include "cloth/ease/ease.h"
#include "cloth/judge/verdict.h"
#include "cloth/scene/collider.h"
#include "geometry/body/mannequin/mannequin.h"
#include "geometry/error.h"
#include "pattern/file/garment_file.h"
#include "pattern/file/pattern_file.h"
#include "pattern/mesh/mesh_panels.h"

int main(int argc, char** argv) try {
  using namespace toile;
  if (argc != 3) throw Error("dress_sample", "needs two files", "give PATTERN.json DRESSED.obj");
  std::vector<Remark> remarks;
  const Pattern pattern = read_pattern(argv[1], remarks);
  PanelMesh garment = mesh_panels(pattern, {.edge_length = 0.025}, remarks);
  const Mannequin mannequin = make_mannequin();
  const Collider collider(mannequin.surface);

  Scene scene;
  scene.fabric = find_fabric("cotton-poplin");
  scene.collider = &collider;
  scene.skeleton = &mannequin.skeleton;
  const DressResult result = dress(garment, scene, {});
  garment.placed = result.placement.initial;
  const DressedGarment dressed = as_dressed(garment, result.nodes, result.triangles);
  write_dressed(argv[2], dressed);
  const Judgement judgement = judge(garment, dressed, mannequin.surface, &mannequin.skeleton,
                                    {result.converged, {}, result.tight_seams});
  std::cout << "verdict: " << to_string(judgement.verdict) << "\nmean gap to the skin: "
            << 1000 * measure_ease(dressed, collider.skin()).garment.mean << " mm\n";
  return judgement.verdict == Verdict::sewn ? 0 : 3;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
