#include "io/view/ray_image.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include "geometry/error.h"

namespace toile {
namespace ray_image_test {

/// A right-angled triangle in the plane z = `z` that faces +z; legs of one metre from the origin.
PictureMesh facing_triangle(const Colour& colour, double z = 0, double size = 1) {
  PictureMesh shown;
  shown.mesh.points = {{0, 0, z}, {size, 0, z}, {0, size, z}};
  shown.mesh.triangles = {{0, 1, 2}};
  shown.colour = colour;
  return shown;
}

/// A camera at +z that sees the square (0, 0)-(1, 1) as 100 x 100 pixels.
Camera square_camera() {
  Camera camera;
  camera.centre = {0.5, 0.5, 0};
  camera.metres_per_pixel = 0.01;
  return camera;
}

struct Pixel {
  int red, green, blue;
  bool is_red() const { return red > 100 && red > 2 * green && red > 2 * blue; }
  bool is_green() const { return green > 80 && green > 2 * red && green > 2 * blue; }
};

Pixel pixel(const Image& image, int x, int y) {
  const std::uint8_t* at = image.bytes.data() + 3 * (y * image.width + x);
  return {at[0], at[1], at[2]};
}

int count_red(const Image& image) {
  int count = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) count += pixel(image, x, y).is_red() ? 1 : 0;
  }
  return count;
}

TEST(RayImage, TriangleCoversItsShareOfThePixels) {
  const RayScene scene({facing_triangle({0.9, 0.05, 0.05})});
  const Image image = scene.render(square_camera(), 100, 100);
  ASSERT_EQ(image.bytes.size(), 30000U);
  EXPECT_NEAR(count_red(image), 5000, 110);    // half the square, its long edge blended
  EXPECT_TRUE(pixel(image, 5, 95).is_red());   // the right angle is at the lower left
  EXPECT_FALSE(pixel(image, 95, 5).is_red());  // and nothing at the upper right
  EXPECT_GT(pixel(image, 95, 5).green, 240);
}

TEST(RayImage, PerspectiveAgreesWithParallelInTheCentrePlane) {
  const RayScene scene({facing_triangle({0.9, 0.05, 0.05})});
  Camera camera = square_camera();
  camera.field_of_view = 0.5;
  EXPECT_NEAR(count_red(scene.render(camera, 100, 100)), 5000, 110);
  camera.centre.z() = 1;  // the triangle is now a metre behind the plane of that scale
  EXPECT_LT(count_red(scene.render(camera, 100, 100)), 4000);
}

TEST(RayImage, NearerSurfaceHidesTheFarther) {
  const RayScene scene(
      {facing_triangle({0.9, 0.05, 0.05}, 0), facing_triangle({0.05, 0.8, 0.05}, 0.2, 0.5)});
  const Image image = scene.render(square_camera(), 100, 100);
  EXPECT_TRUE(pixel(image, 10, 90).is_green());
  EXPECT_TRUE(pixel(image, 80, 95).is_red());
}

TEST(RayImage, BackFacesAreDarker) {
  PictureMesh front = facing_triangle({0.8, 0.8, 0.8});
  PictureMesh back = front;
  std::swap(back.mesh.triangles[0][1], back.mesh.triangles[0][2]);
  const Pixel seen_front = pixel(RayScene({front}).render(square_camera(), 100, 100), 20, 80);
  const Pixel seen_back = pixel(RayScene({back}).render(square_camera(), 100, 100), 20, 80);
  EXPECT_LT(seen_back.green, seen_front.green - 30);
  EXPECT_GT(seen_back.blue, seen_back.green + 10);  // violet
  back.inside_shown = false;
  const Pixel alike = pixel(RayScene({back}).render(square_camera(), 100, 100), 20, 80);
  EXPECT_NEAR(alike.green, seen_front.green, 1);
}

TEST(RayImage, ValuesGoThroughTheRampBetweenPoints) {
  PictureMesh shown = facing_triangle({});
  shown.values = {-1, 3, 1};
  shown.ramp = {0, 3, {{0.05, 0.8, 0.05}, {0.05, 0.8, 0.05}}, {0.9, 0.05, 0.05}};
  const Image image = RayScene({shown}).render(square_camera(), 100, 100);
  EXPECT_TRUE(pixel(image, 20, 99).is_red());    // value -0.2: below
  EXPECT_TRUE(pixel(image, 30, 99).is_green());  // value 0.2
}

TEST(RayImage, BordersBetweenRegionsAreDrawn) {
  PictureMesh shown;
  shown.mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  shown.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Image plain = RayScene({shown}).render(square_camera(), 100, 100);
  shown.regions = {0, 1};
  const Image parted = RayScene({shown}).render(square_camera(), 100, 100);
  EXPECT_LT(pixel(parted, 50, 49).red, pixel(plain, 50, 49).red - 20);
  EXPECT_EQ(pixel(parted, 50, 20).red, pixel(plain, 50, 20).red);
}

TEST(RayImage, SameBytesForAnyNumberOfThreads) {
  const auto bytes = [] {
    const RayScene scene(
        {facing_triangle({0.9, 0.05, 0.05}), facing_triangle({0, 0, 1}, 0.1, 0.4)});
    return scene.render(square_camera(), 100, 100).bytes;
  };
  const std::vector<std::uint8_t> all = bytes();
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(bytes(), all);
}

TEST(RayImage, NothingToShowIsAnError) {
  EXPECT_THROW(RayScene({PictureMesh{}}), Error);
  EXPECT_THROW(RayScene({}), Error);
}

}  // namespace ray_image_test
}  // namespace toile
