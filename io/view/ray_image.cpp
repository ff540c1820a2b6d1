#include "io/view/ray_image.h"

#include <embree3/rtcore.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/error.h"
#include "geometry/parallel.h"

namespace toile {

namespace {

constexpr Colour background{251 / 255.0, 251 / 255.0, 250 / 255.0};  // a soft white

alignas(16) constexpr int all_lanes[4] = {-1, -1, -1,
                                          -1};  // the valid rays of a packet of four: all

/// The shading of a point.
struct PointShading {
  Vec3 normal = Vec3::UnitY();
  double open_front = 1;  ///< share of the sky that is visible before the surface
  double open_back = 1;   ///< and behind it
};

/// Unit vectors spread evenly over the sphere, on a golden-angle spiral.
std::vector<Vec3> sphere_directions(int count) {
  std::vector<Vec3> directions;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double y = 1 - 2 * (i + 0.5) / count;
    const double r = std::sqrt(1 - y * y);
    directions.emplace_back(r * std::cos(golden * i), y, r * std::sin(golden * i));
  }
  return directions;
}

/// The points' normals: means of their triangles' normals, weighted by the angle at the point.
std::vector<PointShading> point_normals(const TriangleMesh& mesh) {
  std::vector<PointShading> shadings(mesh.points.size());
  for (PointShading& shading : shadings) shading.normal.setZero();
  for (const Triangle& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = mesh.points[static_cast<std::size_t>(triangle[i])];
      const Vec3 a = mesh.points[static_cast<std::size_t>(triangle[(i + 1) % 3])] - p;
      const Vec3 b = mesh.points[static_cast<std::size_t>(triangle[(i + 2) % 3])] - p;
      const Vec3 across = a.cross(b);
      const double size = across.norm();
      if (size == 0) continue;
      shadings[static_cast<std::size_t>(triangle[i])].normal +=
          across * (std::atan2(size, a.dot(b)) / size);
    }
  }
  for (PointShading& shading : shadings) {
    if (shading.normal.norm() > 0) shading.normal.normalize();
  }
  return shadings;
}

RTCRay ray_of(const Vec3& origin, const Vec3& direction, double from, double to) {
  RTCRay ray{};
  ray.org_x = static_cast<float>(origin.x());
  ray.org_y = static_cast<float>(origin.y());
  ray.org_z = static_cast<float>(origin.z());
  ray.dir_x = static_cast<float>(direction.x());
  ray.dir_y = static_cast<float>(direction.y());
  ray.dir_z = static_cast<float>(direction.z());
  ray.tnear = static_cast<float>(from);
  ray.tfar = static_cast<float>(to);
  ray.mask = ~0U;
  return ray;
}

}  // namespace

struct RayScene::Data {
  std::vector<PictureMesh> meshes;
  std::vector<std::vector<PointShading>> shadings;
  std::vector<std::vector<Light>> lights;  // one a triangle, or one for the mesh
  std::vector<std::int32_t> first_region;  // per mesh, added to its regions to make them distinct
  Eigen::AlignedBox3d box;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  RTCScene sunken = nullptr;  // the meshes that show through others; null if there are none

  ~Data() {
    if (sunken != nullptr) rtcReleaseScene(sunken);
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }

  RTCScene new_scene() const;
  RTCGeometry new_geometry(const TriangleMesh& mesh) const;
  void build_scenes();
  void find_openness();
  double value_at(std::size_t mesh, std::size_t triangle, double u, double v) const;
  Light surface_light(std::size_t mesh, std::size_t triangle, double u, double v) const;
  void bring_forward(RTCRayHit4& hit, const RTCRayHit4& fresh) const;
  Sample shade(const RTCRayHit4& hit, std::size_t lane, const Vec3& towards_key) const;
};

RTCScene RayScene::Data::new_scene() const {
  const RTCScene made = rtcNewScene(device);
  rtcSetSceneFlags(made, RTC_SCENE_FLAG_ROBUST);
  return made;
}

RTCGeometry RayScene::Data::new_geometry(const TriangleMesh& mesh) const {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              3 * sizeof(float), std::max<std::size_t>(mesh.points.size(), 1)));
  auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned),
      std::max<std::size_t>(mesh.triangles.size(), 1)));
  if (points == nullptr || corners == nullptr) throw std::bad_alloc();
  std::fill_n(points, 3, 0.0F);
  std::fill_n(corners, 3, 0U);
  for (const Vec3& point : mesh.points) {
    for (int k = 0; k < 3; ++k) *points++ = static_cast<float>(point[k]);
  }
  for (const Triangle& triangle : mesh.triangles) {
    for (const int corner : triangle) *corners++ = static_cast<unsigned>(corner);
  }
  rtcCommitGeometry(geometry);
  return geometry;
}

/// Builds the Embree scenes. The index of a mesh is its geometry's id in both scenes.
void RayScene::Data::build_scenes() {
  scene = new_scene();
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const RTCGeometry geometry = new_geometry(meshes[m].mesh);
    rtcAttachGeometryByID(scene, geometry, static_cast<unsigned>(m));
    if (meshes[m].shows_through > 0 && !meshes[m].values.empty()) {
      if (sunken == nullptr) sunken = new_scene();
      rtcAttachGeometryByID(sunken, geometry, static_cast<unsigned>(m));
    }
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(scene);
  if (sunken != nullptr) rtcCommitScene(sunken);
}

/// Finds the share of the half sphere over each point, weighted by the cosine, whose rays meet
/// nothing near. All points use the same directions. So the error is smooth over the surface, not
/// noise.
void RayScene::Data::find_openness() {
  static const std::vector<Vec3> directions = sphere_directions(96);
  const double reach = 0.15 * box.diagonal().norm();
  const double lift = 1e-4 * box.diagonal().norm();
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    parallel_for_items(shadings[m].size(), [&](std::size_t i) {
      PointShading& shading = shadings[m][i];
      std::array<double, 2> open{}, all{};
      for (const Vec3& direction : directions) {
        const double cosine = shading.normal.dot(direction);
        const int side = cosine > 0 ? 0 : 1;
        if (side == 1 && !meshes[m].inside_shown) continue;
        const Vec3 origin = meshes[m].mesh.points[i] + (side == 0 ? lift : -lift) * shading.normal;
        RTCRay ray = ray_of(origin, direction, lift, reach);
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded1(scene, &context, &ray);
        const double weight = std::abs(cosine);
        all[static_cast<std::size_t>(side)] += weight;
        if (ray.tfar >= 0) open[static_cast<std::size_t>(side)] += weight;
      }
      if (all[0] > 0) shading.open_front = open[0] / all[0];
      if (all[1] > 0) shading.open_back = open[1] / all[1];
    });
  }
}

RayScene::RayScene(std::vector<PictureMesh> meshes) : data_(std::make_unique<Data>()) {
  Data& data = *data_;
  data.meshes = std::move(meshes);
  std::size_t triangles = 0;
  std::int32_t next_region = 0;
  for (const PictureMesh& mesh : data.meshes) {
    triangles += mesh.mesh.triangles.size();
    for (const Vec3& point : mesh.mesh.points) data.box.extend(point);
    data.shadings.push_back(point_normals(mesh.mesh));
    std::vector<Light>& lights = data.lights.emplace_back();
    for (const Colour& colour : mesh.triangle_colours) lights.push_back(light_of(colour));
    if (lights.empty()) lights.push_back(light_of(mesh.colour));
    data.first_region.push_back(next_region);
    next_region += 1 + (mesh.regions.empty() ? 0 : *std::ranges::max_element(mesh.regions));
  }
  if (triangles == 0) throw Error("picture", "there is no triangle to show", "");

  data.device = rtcNewDevice(nullptr);
  if (data.device == nullptr) {
    throw Error("picture", "the ray caster (Embree) could not start", "this needs SSE2 or NEON");
  }
  data.build_scenes();
  data.find_openness();
}

RayScene::~RayScene() = default;

const std::vector<PictureMesh>& RayScene::meshes() const { return data_->meshes; }

double RayScene::Data::value_at(std::size_t mesh, std::size_t triangle, double u, double v) const {
  const Triangle& t = meshes[mesh].mesh.triangles[triangle];
  const auto value = [&](std::size_t k) {
    return meshes[mesh].values[static_cast<std::size_t>(t[k])];
  };
  return (1 - u - v) * value(0) + u * value(1) + v * value(2);
}

Light RayScene::Data::surface_light(std::size_t mesh, std::size_t triangle, double u,
                                    double v) const {
  // It interpolates the value, not its colour. So the ramp's steps keep their places.
  if (!meshes[mesh].values.empty()) {
    return light_of(meshes[mesh].ramp.at(value_at(mesh, triangle, u, v)));
  }
  return lights[mesh].size() > 1 ? lights[mesh][triangle] : lights[mesh][0];
}

/// Replaces hits by the surfaces that show through there. `fresh` holds the rays of `hit` before
/// they were cast.
void RayScene::Data::bring_forward(RTCRayHit4& hit, const RTCRayHit4& fresh) const {
  RTCRayHit4 under = fresh;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect4(all_lanes, sunken, &context, &under);
  for (std::size_t lane = 0; lane < 4; ++lane) {
    const std::size_t mesh = under.hit.geomID[lane];
    if (mesh == RTC_INVALID_GEOMETRY_ID || hit.hit.geomID[lane] == mesh) continue;
    const double cover = under.ray.tfar[lane] - hit.ray.tfar[lane];
    if (cover > meshes[mesh].shows_through ||
        value_at(mesh, under.hit.primID[lane], under.hit.u[lane], under.hit.v[lane]) >=
            meshes[mesh].ramp.low) {
      continue;
    }
    hit.ray.tfar[lane] = under.ray.tfar[lane];
    hit.hit.u[lane] = under.hit.u[lane];
    hit.hit.v[lane] = under.hit.v[lane];
    hit.hit.primID[lane] = under.hit.primID[lane];
    hit.hit.geomID[lane] = under.hit.geomID[lane];
  }
}

Sample RayScene::Data::shade(const RTCRayHit4& hit, std::size_t lane,
                             const Vec3& towards_key) const {
  const std::size_t mesh = hit.hit.geomID[lane];
  const std::size_t index = hit.hit.primID[lane];
  const Triangle& triangle = meshes[mesh].mesh.triangles[index];
  const double u = hit.hit.u[lane];
  const double v = hit.hit.v[lane];
  const std::array<double, 3> weight = {1 - u - v, u, v};
  const auto corner = [&](std::size_t k) -> const Vec3& {
    return meshes[mesh].mesh.points[static_cast<std::size_t>(triangle[k])];
  };
  const Vec3 facet = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
  const Vec3 ray(hit.ray.dir_x[lane], hit.ray.dir_y[lane], hit.ray.dir_z[lane]);

  const bool back = facet.dot(ray) > 0;
  Vec3 normal = Vec3::Zero();
  double open = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const PointShading& shading = shadings[mesh][static_cast<std::size_t>(triangle[k])];
    // An edge of more than about 70 degrees counts as sharp.
    normal += weight[k] * (shading.normal.dot(facet) > 0.35 ? shading.normal : facet);
    open += weight[k] * (back ? shading.open_back : shading.open_front);
  }
  normal.normalize();
  if (back) normal = -normal;
  // A surface that shows through is enclosed all around, but should not be dark.
  const PictureMesh& shown = meshes[mesh];
  if (shown.shows_through > 0 && !shown.values.empty() &&
      value_at(mesh, index, u, v) < shown.ramp.low) {
    open = 1;
  }

  const double head_on = std::max(0.0, -normal.dot(ray));
  const double key = std::max(0.0, normal.dot(towards_key));
  const double brightness = (0.16 + 0.84 * open) * (0.20 + 0.32 * head_on + 0.52 * key);
  Light light = surface_light(mesh, index, u, v);
  if (back && meshes[mesh].inside_shown) {
    // The inside is darker and tinted violet, a colour that no panel has.
    light = {0.42 * light.red + 0.10, 0.38 * light.green + 0.03, 0.42 * light.blue + 0.14};
  }
  Sample sample;
  sample.red = static_cast<float>(brightness * light.red);
  sample.green = static_cast<float>(brightness * light.green);
  sample.blue = static_cast<float>(brightness * light.blue);
  sample.region =
      first_region[mesh] + (meshes[mesh].regions.empty() ? 0 : meshes[mesh].regions[index]);
  return sample;
}

Image RayScene::render(const Camera& camera, int width, int height) const {
  if (width < 1 || height < 1) return {};
  const Vec3 right = camera.forward.cross(camera.up).normalized();
  const Vec3 towards_key = (-0.75 * camera.forward + 0.55 * camera.up - 0.45 * right).normalized();
  const double step = camera.metres_per_pixel / 2;
  const double half_height = 0.5 * camera.metres_per_pixel * height;
  const double reach =
      2 * data_->box.diagonal().norm() + (data_->box.center() - camera.centre).norm();
  const double eye_distance =
      camera.field_of_view > 0 ? half_height / std::tan(0.5 * camera.field_of_view) : reach;
  const Vec3 eye = camera.centre - eye_distance * camera.forward;

  SampleGrid grid(width, height, background);
  parallel_for_items(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      RTCRayHit4 hit;
      for (std::size_t lane = 0; lane < 4; ++lane) {
        const double across = (2 * x + static_cast<int>(lane % 2) + 0.5 - width) * step;
        const double down = (2 * y + static_cast<int>(lane / 2) + 0.5 - height) * step;
        const Vec3 seen = camera.centre + across * right - down * camera.up;
        const Vec3 direction =
            camera.field_of_view > 0 ? (seen - eye).normalized() : camera.forward;
        const Vec3 origin = camera.field_of_view > 0 ? eye : Vec3(seen - reach * camera.forward);
        const RTCRay ray = ray_of(origin, direction, 0, eye_distance + 2 * reach);
        hit.ray.org_x[lane] = ray.org_x;
        hit.ray.org_y[lane] = ray.org_y;
        hit.ray.org_z[lane] = ray.org_z;
        hit.ray.tnear[lane] = ray.tnear;
        hit.ray.dir_x[lane] = ray.dir_x;
        hit.ray.dir_y[lane] = ray.dir_y;
        hit.ray.dir_z[lane] = ray.dir_z;
        hit.ray.time[lane] = 0;
        hit.ray.tfar[lane] = ray.tfar;
        hit.ray.mask[lane] = ray.mask;
        hit.ray.id[lane] = 0;
        hit.ray.flags[lane] = 0;
        hit.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
        hit.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
      }
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
      const RTCRayHit4 fresh = hit;
      rtcIntersect4(all_lanes, data_->scene, &context, &hit);
      if (data_->sunken != nullptr) data_->bring_forward(hit, fresh);
      for (std::size_t lane = 0; lane < 4; ++lane) {
        if (hit.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) continue;
        grid.at(x, y, static_cast<int>(lane)) = data_->shade(hit, lane, towards_key);
      }
    }
  });
  grid.draw_borders();
  return grid.image();
}

}  // namespace toile
