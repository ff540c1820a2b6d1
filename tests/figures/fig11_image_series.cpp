// Writes Fig. 11 of Zhong & Xu 2009: a dress on the walking mannequin; trousers, then a jacket over
// them, on the standing one.
#include "tests/figures/dressing_pictures.h"
#include "tests/figures/sheet.h"

namespace toile::figures {
namespace {

TriangleMesh surface(const PaperDressing& dressing) {
  return {dressing.dressed.points, dressing.dressed.triangles};
}

void show(Sheet& sheet, const std::string& heading, const PaperDressing& dressing,
          const Wearer& wearer, const std::vector<TriangleMesh>& below, View second) {
  sheet.pictures(heading, state_pictures(dressing, wearer, {.below = below}));
  sheet.pictures(heading + ", " + std::string(view_names[static_cast<std::size_t>(second)]),
                 state_pictures(dressing, wearer, {.view = second, .below = below}));
  sheet.garment(dressing);
}

void walk(const SheetSettings& settings, Sheet& sheet) {
  const Wearer wearer(walking_pose());
  const PaperDressing dress = dress_by_paper(
      "walking dress", sample_garment("walking_dress", settings.edge_length), wearer);
  show(sheet, "(a) A dress on the walking mannequin", dress, wearer, {}, View::left);
}

void stand(const SheetSettings& settings, Sheet& sheet) {
  Wearer wearer(standing_pose());
  const PaperDressing trousers =
      dress_by_paper("trousers", sample_garment("trousers", settings.edge_length), wearer);
  show(sheet, "(b) Trousers on the standing mannequin", trousers, wearer, {}, View::back);
  if (trousers.judgement.verdict != Verdict::sewn) {
    sheet.say("The trousers are " + to_string(trousers.judgement.verdict) +
              ": the jacket is not dressed over them.");
    return;
  }
  wearer.subject.add_layer(surface(trousers));
  const PaperDressing jacket = dress_by_paper(
      "jacket over trousers", sample_garment("jacket", settings.edge_length), wearer);
  show(sheet, "(b) The jacket over them, its sleeves rolled around the arms", jacket, wearer,
       {surface(trousers)}, View::back);
}

void write(const SheetSettings& settings) {
  Sheet sheet(settings.folder, "fig11", "Fig. 11: image series of dressing");
  sheet.say(
      "The paper shows pictures without numbers: “vivid, realistic dressing effects”. Ours "
      "are judged by the table of garments.");
  walk(settings, sheet);
  stand(settings, sheet);
  sheet.write();
}

}  // namespace
}  // namespace toile::figures

int main(int argc, char** argv) {
  return toile::figures::run_sheet(argc, argv, toile::figures::write);
}
