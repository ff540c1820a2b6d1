// The pictures of a dressing: its states side by side, its panels as meshed.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "io/view/picture.h"
#include "tests/figures/paper_dressing.h"

namespace toile::figures {

/// PNG bytes and caption, as Sheet::pictures() takes them.
using CaptionedPictures = std::vector<std::pair<std::string, std::string>>;

struct StatePictureOptions {
  View view = View::front;
  std::vector<TriangleMesh> below{};  ///< layers worn before, in one colour each
  /// Only where the cloth is, and without the arms, which hide side seams.
  bool close_up = false;
  int view_width = 480;  ///< pixels
};

/// One picture a state, all to one scale, each panel in its own colour.
CaptionedPictures state_pictures(const PaperDressing& dressing, const Wearer& wearer,
                                 const StatePictureOptions& options = {});

/// The flat panels in rows, every triangle outlined.
std::string mesh_picture(const PanelMesh& garment);

/// The garment as dressed, coloured by how much each triangle's edges are strained, percent.
std::string strain_picture(const PaperDressing& dressing, const Wearer& wearer);

}  // namespace toile::figures
