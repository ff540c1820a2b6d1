#include "tests/figures/dressing_pictures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/body/bones.h"

namespace toile::figures {
namespace {

constexpr Colour skin{0.80, 0.76, 0.73};

/// Meshes too small to be seen that make all pictures of one figure show the same part of space.
PictureMesh corners(const Vec3& low, const Vec3& high) {
  PictureMesh frame;
  for (const Vec3& corner : {low, high}) {
    const int first = static_cast<int>(frame.mesh.points.size());
    for (int k = 0; k < 3; ++k) frame.mesh.points.push_back(corner + 1e-6 * Vec3::Unit(k));
    frame.mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return frame;
}

PictureMesh panels_of(const PanelMesh& garment, const std::vector<Vec3>& points) {
  PictureMesh cloth;
  cloth.mesh = {points, garment.triangles};
  cloth.framed = false;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    for (int t = 0; t < garment.panels[p].triangles; ++t) {
      cloth.regions.push_back(static_cast<int>(p) + 1);
      cloth.triangle_colours.push_back(quiet_colour(static_cast<int>(p)));
    }
  }
  return cloth;
}

/// Whether an arm's bones are nearer than any other part's.
bool on_arm(const std::vector<Bones>& arms, const std::vector<Bones>& others, const Vec3& point) {
  const auto nearest = [&](const std::vector<Bones>& all) {
    double least = std::numeric_limits<double>::max();
    for (const Bones& bones : all) least = std::min(least, bones.distance(point));
    return least;
  };
  return nearest(arms) < nearest(others);
}

PictureMesh body_of(const Wearer& wearer, bool with_arms) {
  PictureMesh body;
  body.mesh = wearer.mannequin.surface;
  body.colour = skin;
  body.inside_shown = false;
  body.framed = false;
  if (!with_arms) {
    std::vector<Bones> arms;
    std::vector<Bones> others;
    for (const std::string_view name : body_parts) {
      const BodyPart part = body_part(name);
      (is_arm(part) ? arms : others).emplace_back(wearer.mannequin.skeleton, part);
    }
    std::erase_if(body.mesh.triangles,
                  [&](const Triangle& t) { return on_arm(arms, others, body.mesh.points[t[0]]); });
  }
  return body;
}

}  // namespace

CaptionedPictures state_pictures(const PaperDressing& dressing, const Wearer& wearer,
                                 const StatePictureOptions& options) {
  const std::vector<Vec3>& body = wearer.mannequin.surface.points;
  Vec3 low = dressing.states.front().points.front();
  Vec3 high = low;
  const auto take_in = [&](const std::vector<Vec3>& points) {
    for (const Vec3& p : points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  };
  if (!options.close_up) take_in(body);
  for (const DressingState& state : dressing.states) take_in(state.points);
  CaptionedPictures pictures;
  for (const DressingState& state : dressing.states) {
    std::vector<PictureMesh> meshes;
    meshes.push_back(panels_of(dressing.garment, state.points));
    meshes.push_back(body_of(wearer, !options.close_up));
    meshes.push_back(corners(low, high));
    int colour = static_cast<int>(dressing.garment.panels.size());
    for (const TriangleMesh& layer : options.below) {
      PictureMesh cloth;
      cloth.mesh = layer;
      cloth.colour = quiet_colour(colour++);
      cloth.framed = false;
      meshes.push_back(std::move(cloth));
    }
    Picture picture;
    picture.views = {options.view};
    picture.view_width = options.view_width;
    pictures.emplace_back(picture_png(std::move(meshes), picture), state.caption);
  }
  return pictures;
}

std::string mesh_picture(const PanelMesh& garment) {
  constexpr double gap = 0.03;
  constexpr double row_width = 2;
  PictureMesh cloth = panels_of(garment, std::vector<Vec3>(garment.flat.size(), Vec3::Zero()));
  cloth.framed = true;
  double right = 0;
  double top = 0;
  double row_height = 0;
  for (const MeshedPanel& panel : garment.panels) {
    Vec2 low = garment.flat[panel.first_point];
    Vec2 high = low;
    for (int i = panel.first_point; i < panel.first_point + panel.points; ++i) {
      low = low.cwiseMin(garment.flat[i]);
      high = high.cwiseMax(garment.flat[i]);
    }
    const Vec2 size = high - low;
    if (right > 0 && right + size.x() > row_width) {
      top -= row_height + gap;
      right = row_height = 0;
    }
    for (int i = panel.first_point; i < panel.first_point + panel.points; ++i) {
      const Vec2 at = garment.flat[i] - low;
      cloth.mesh.points[i] = Vec3(right + at.x(), top - size.y() + at.y(), 0);
    }
    right += size.x() + gap;
    row_height = std::max(row_height, size.y());
  }
  // A line parts different regions: every triangle is one.
  for (std::size_t t = 0; t < cloth.regions.size(); ++t) cloth.regions[t] = static_cast<int>(t);
  Picture picture;
  picture.views = {View::front};
  picture.view_width = 1600;
  return picture_png({std::move(cloth)}, picture);
}

std::string strain_picture(const PaperDressing& dressing, const Wearer& wearer) {
  const PanelMesh& garment = dressing.garment;
  std::vector<double> percent(garment.flat.size(), 0);
  const std::vector<Vec3>& points = dressing.states.back().points;
  for (const Triangle& t : garment.triangles) {
    for (int k = 0; k < 3; ++k) {
      const int a = t[k];
      const int b = t[(k + 1) % 3];
      const double strain =
          100 *
          std::abs((points[a] - points[b]).norm() / (garment.flat[a] - garment.flat[b]).norm() - 1);
      percent[a] = std::max(percent[a], strain);
      percent[b] = std::max(percent[b], strain);
    }
  }
  Picture picture;
  picture.view_width = 500;
  picture.bar = ColourBar{"largest strain of the edges at a point, %", magnitude_ramp(0, 2), ""};
  PictureMesh cloth;
  cloth.mesh = {points, garment.triangles};
  cloth.values = percent;
  cloth.ramp = picture.bar->ramp;
  std::vector<PictureMesh> meshes;
  meshes.push_back(std::move(cloth));
  meshes.push_back(body_of(wearer, true));
  return picture_png(std::move(meshes), picture);
}

}  // namespace toile::figures
