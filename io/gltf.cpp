#include "io/gltf.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "io/bytes.h"
#include "io/text.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

// Numbers of the glTF 2.0 specification, 3.6.2 and 4.4.
constexpr std::uint32_t glb_magic = 0x46546C67;  // "glTF"
constexpr std::uint32_t json_chunk = 0x4E4F534A;
constexpr std::uint32_t bin_chunk = 0x004E4942;
constexpr int type_float = 5126;
constexpr int type_uint = 5125;
constexpr int of_vertices = 34962;
constexpr int of_indices = 34963;

/// The buffer and what lies in it.
class Buffer {
 public:
  /// Adds numbers of four bytes as an accessor of its own, and returns its index.
  template <class Number>
  int add(const std::vector<Number>& numbers, int width) {
    static_assert(sizeof(Number) == 4);  // so all accessors begin at a multiple of four
    constexpr bool is_index = std::is_integral_v<Number>;
    static constexpr const char* types[] = {"", "SCALAR", "VEC2", "VEC3"};
    views_.push_back({{"buffer", 0},
                      {"byteOffset", bytes_.size()},
                      {"byteLength", 4 * numbers.size()},
                      {"target", is_index ? of_indices : of_vertices}});
    for (const Number number : numbers) store(bytes_, number);
    accessors_.push_back({{"bufferView", views_.size() - 1},
                          {"componentType", is_index ? type_uint : type_float},
                          {"count", numbers.size() / static_cast<std::size_t>(width)},
                          {"type", types[width]}});
    return static_cast<int>(accessors_.size()) - 1;
  }
  /// glTF asks for the box of all positions.
  int add_positions(const std::vector<float>& numbers) {
    const int accessor = add(numbers, 3);
    for (std::size_t k = 0; k < 3; ++k) {
      float least = numbers[k];
      float most = numbers[k];
      for (std::size_t i = k; i < numbers.size(); i += 3) {
        least = std::min(least, numbers[i]);
        most = std::max(most, numbers[i]);
      }
      accessors_.back()["min"].push_back(least);
      accessors_.back()["max"].push_back(most);
    }
    return accessor;
  }
  void finish(Json& json) const {
    json["buffers"] = {{{"byteLength", bytes_.size()}}};
    json["bufferViews"] = views_;
    json["accessors"] = accessors_;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  Json views_ = Json::array();
  Json accessors_ = Json::array();
};

std::vector<float> floats(const std::vector<Vec3>& vectors) {
  std::vector<float> numbers;
  for (const Vec3& vector : vectors) {
    for (int k = 0; k < 3; ++k) numbers.push_back(static_cast<float>(vector[k]));
  }
  return numbers;
}

std::vector<float> floats(const std::vector<Vec2>& map) {
  std::vector<float> numbers;
  for (const Vec2& place : map) {
    numbers.push_back(static_cast<float>(place.x()));
    numbers.push_back(static_cast<float>(1 - place.y()));
  }
  return numbers;
}

std::vector<float> light(const Colour& colour) {
  std::vector<float> numbers;
  for (const double channel : {colour.red, colour.green, colour.blue}) {
    numbers.push_back(static_cast<float>(to_light(channel)));
  }
  return numbers;
}

Json mesh_json(const GltfMesh& mesh, Buffer& buffer) {
  Json attributes = {{"POSITION", buffer.add_positions(floats(mesh.points))},
                     {"NORMAL", buffer.add(floats(mesh.normals), 3)}};
  for (std::size_t i = 0; i < mesh.maps.size(); ++i) {
    attributes["TEXCOORD_" + std::to_string(i)] = buffer.add(floats(mesh.maps[i]), 2);
  }
  if (!mesh.colours.empty()) {
    std::vector<float> channels;
    for (const Colour& colour : mesh.colours) {
      for (const float channel : light(colour)) channels.push_back(channel);
    }
    attributes["COLOR_0"] = buffer.add(channels, 3);
  }
  std::vector<std::uint32_t> corners;
  for (const Triangle& triangle : mesh.triangles) {
    for (const int corner : triangle) corners.push_back(static_cast<std::uint32_t>(corner));
  }
  return {{"name", valid_utf8(mesh.name)},
          {"primitives",
           {{{"attributes", attributes},
             {"indices", buffer.add(corners, 1)},
             {"material", mesh.material}}}}};
}

Json material_json(const GltfMaterial& material) {
  Json colour = light(material.colour);
  colour.push_back(1);
  return {{"name", valid_utf8(material.name)},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", colour}, {"metallicFactor", 0}, {"roughnessFactor", 0.9}}},
          {"doubleSided", true}};
}

void add_chunk(std::string& file, std::uint32_t type, std::string content, char filler) {
  content.resize((content.size() + 3) / 4 * 4, filler);
  store(file, static_cast<std::uint32_t>(content.size()));
  store(file, type);
  file += content;
}

}  // namespace

std::string format_glb(const GltfScene& scene) {
  Json json;
  json["asset"] = {{"version", "2.0"}, {"generator", scene.generator}};
  json["scene"] = 0;
  json["scenes"] = {{{"nodes", Json::array()}}};
  if (!scene.colours.empty()) json["scenes"][0]["extras"]["colours"] = scene.colours;
  for (const GltfMaterial& material : scene.materials) {
    json["materials"].push_back(material_json(material));
  }
  Buffer buffer;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    json["scenes"][0]["nodes"].push_back(i);
    json["nodes"].push_back({{"name", valid_utf8(scene.meshes[i].name)}, {"mesh", i}});
    json["meshes"].push_back(mesh_json(scene.meshes[i], buffer));
  }
  buffer.finish(json);
  std::string chunks;
  add_chunk(chunks, json_chunk, json.dump(), ' ');
  add_chunk(chunks, bin_chunk, buffer.bytes(), '\0');
  constexpr std::size_t header = 12;
  if (header + chunks.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw Error("glTF", "the meshes are too large for a file of 4 GiB", "use longer edges");
  }
  std::string file;
  store(file, glb_magic);
  store(file, std::uint32_t{2});
  store(file, static_cast<std::uint32_t>(header + chunks.size()));
  return file + chunks;
}

}  // namespace toile
