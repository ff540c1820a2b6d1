// The Polygon File Format [Turk 1994]. A text header declares elements and their properties. The
// elements follow as text or as binary of either byte order. The parser reads points and faces and
// skips all else.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "geometry/error.h"
#include "io/bytes.h"
#include "io/limits.h"
#include "io/line_scanner.h"
#include "io/mesh_formats.h"
#include "io/text.h"

namespace toile {

namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(Type type) {
  switch (type) {
    case Type::int8:
    case Type::uint8:
      return 1;
    case Type::int16:
    case Type::uint16:
      return 2;
    case Type::int32:
    case Type::uint32:
    case Type::float32:
      return 4;
    case Type::float64:
      return 8;
  }
  return 0;
}

struct Property {
  std::string name;
  Type type = Type::float32;
  std::optional<Type> count;  // type of a list's length; none: no list
};

struct Element {
  std::string name;
  long long count = 0;
  std::vector<Property> properties;
};

struct Header {
  std::optional<std::endian> binary;  // byte order; none: text
  std::vector<Element> elements;
};

Type parse_type(LineScanner& scanner) {
  const std::string_view word = scanner.word();
  if (word == "char" || word == "int8") return Type::int8;
  if (word == "uchar" || word == "uint8") return Type::uint8;
  if (word == "short" || word == "int16") return Type::int16;
  if (word == "ushort" || word == "uint16") return Type::uint16;
  if (word == "int" || word == "int32") return Type::int32;
  if (word == "uint" || word == "uint32") return Type::uint32;
  if (word == "float" || word == "float32") return Type::float32;
  if (word == "double" || word == "float64") return Type::float64;
  scanner.fail(shown(word) + " is not a PLY type", "");
}

bool is_whole(Type type) { return type != Type::float32 && type != Type::float64; }

Property parse_property(LineScanner& scanner) {
  Property property;
  LineScanner ahead = scanner;
  if (ahead.word() == "list") {
    scanner.word();
    property.count = parse_type(scanner);
    if (!is_whole(*property.count)) scanner.fail("a list's length is no whole number", "");
  }
  property.type = parse_type(scanner);
  property.name = scanner.word();
  if (property.name.empty()) scanner.fail("a property has no name", "");
  return property;
}

Header parse_header(LineScanner& scanner) {
  if (!scanner.next_line()) scanner.fail("the file is empty", "give a PLY file");
  if (const auto magic = scanner.word(); magic != "ply") {
    scanner.fail("begins with " + shown(magic) + " instead of ply", "is it really a PLY file?");
  }
  Header header;
  bool format_known = false;
  for (;;) {
    scanner.need_line("'end_header'");
    const std::string_view keyword = scanner.word();
    if (keyword == "end_header") break;
    if (keyword == "comment" || keyword == "obj_info") continue;
    if (keyword == "format") {
      const std::string_view format = scanner.word();
      if (format == "binary_little_endian") {
        header.binary = std::endian::little;
      } else if (format == "binary_big_endian") {
        header.binary = std::endian::big;
      } else if (format != "ascii") {
        scanner.fail(shown(format) + " is not a PLY format", "");
      }
      format_known = true;
    } else if (keyword == "element") {
      Element& element = header.elements.emplace_back();
      element.name = scanner.word();
      element.count = scanner.integer("the number of elements", 0, std::numeric_limits<int>::max());
    } else if (keyword == "property") {
      if (header.elements.empty()) scanner.fail("a property comes before any element", "");
      header.elements.back().properties.push_back(parse_property(scanner));
    } else {
      scanner.fail(shown(keyword) + " is not a PLY statement", "");
    }
  }
  if (!format_known) scanner.fail("the header names no format", "");
  return header;
}

/// Reads the values after the header one after another, from text or from binary.
class Body {
 public:
  Body(LineScanner& scanner, std::string_view data, const std::string& name,
       std::optional<std::endian> binary)
      : scanner_(scanner), data_(data), name_(name), binary_(binary), at_(scanner.offset()) {}

  /// Begins an element. In a text file each element has a line; in a binary one values follow on.
  void begin(const Element& element, long long number) {
    element_ = &element;
    number_ = number;
    if (!binary_) scanner_.need_line(what());
  }

  double value(Type type) {
    if (!binary_) return scanner_.number("a value of " + what());
    if (data_.size() - at_ < size_of(type))
      fail("the file ends within " + what(), "is it cut off?");
    const char* const bytes = &data_[at_];
    at_ += size_of(type);
    switch (type) {
      case Type::int8:
        return load<std::int8_t>(bytes, *binary_);
      case Type::uint8:
        return load<std::uint8_t>(bytes, *binary_);
      case Type::int16:
        return load<std::int16_t>(bytes, *binary_);
      case Type::uint16:
        return load<std::uint16_t>(bytes, *binary_);
      case Type::int32:
        return load<std::int32_t>(bytes, *binary_);
      case Type::uint32:
        return load<std::uint32_t>(bytes, *binary_);
      case Type::float32:
        return load<float>(bytes, *binary_);
      case Type::float64:
        return load<double>(bytes, *binary_);
    }
    return 0;
  }

  double coordinate(Type type) {
    const double number = value(type);
    const std::string problem = coordinate_problem(number);
    if (!problem.empty()) fail(what() + ": " + problem, coordinate_remedy);
    return number;
  }

  long long whole(Type type, long long low, long long high, const char* which) {
    const double number = value(type);
    if (!(number >= low && number <= high) || number != std::floor(number)) {
      std::string text;
      append_number(text, number);
      fail(std::string(which) + " of " + what() + " is " + text + ", not a whole number from " +
               std::to_string(low) + " to " + std::to_string(high),
           "");
    }
    return static_cast<long long>(number);
  }

  void skip(const Property& property) {
    const long long values =
        property.count ? whole(*property.count, 0, std::numeric_limits<int>::max(), "a list's size")
                       : 1;
    for (long long i = 0; i < values; ++i) value(property.type);
  }

  std::string what() const { return element_->name + " " + std::to_string(number_); }

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
    if (!binary_) scanner_.fail(problem, remedy);
    throw Error(name_ + ", byte " + std::to_string(at_), problem, remedy);
  }

 private:
  LineScanner& scanner_;
  std::string_view data_;
  const std::string& name_;
  std::optional<std::endian> binary_;
  std::size_t at_;
  const Element* element_ = nullptr;
  long long number_ = 0;
};

/// Whether the property is the component x, y or z of what `prefix` stands for.
bool is_axis(const Property& property, std::string_view prefix) {
  const std::string_view name = property.name;
  return !property.count && name.size() == prefix.size() + 1 && name.starts_with(prefix) &&
         name.back() >= 'x' && name.back() <= 'z';
}

void read_point(Body& body, const Element& element, PolygonSoup& soup, std::vector<Vec3>* normals) {
  Vec3 point(0, 0, 0);
  Vec3 normal(0, 0, 0);
  for (const Property& property : element.properties) {
    if (is_axis(property, "")) {
      point[property.name[0] - 'x'] = body.coordinate(property.type);
    } else if (normals != nullptr && is_axis(property, "n")) {
      normal[property.name[1] - 'x'] = body.value(property.type);
    } else {
      body.skip(property);
    }
  }
  soup.points.push_back(point);
  if (normals == nullptr) return;
  const double length = normal.norm();
  normals->push_back(std::isfinite(length) && length > 0 ? Vec3(normal / length) : Vec3::Zero());
}

bool is_corner_list(const Property& property) {
  return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
}

void read_polygon(Body& body, const Element& element, long long points, PolygonSoup& soup) {
  for (const Property& property : element.properties) {
    if (!is_corner_list(property)) {
      body.skip(property);
      continue;
    }
    const long long corners =
        body.whole(*property.count, 3, max_face_corners, "the number of corners");
    std::vector<int>& polygon = soup.polygons.emplace_back();
    for (long long i = 0; i < corners; ++i) {
      polygon.push_back(
          static_cast<int>(body.whole(property.type, 0, points - 1, "a point's index")));
    }
  }
}

void check_properties(const Header& header, const LineScanner& scanner) {
  for (const Element& element : header.elements) {
    int axes = 0;
    int corner_lists = 0;
    for (const Property& property : element.properties) {
      axes +=
          !property.count && (property.name == "x" || property.name == "y" || property.name == "z");
      corner_lists += is_corner_list(property);
    }
    if (element.name == "vertex" && axes != 3) {
      scanner.fail("the vertices need the properties x, y and z", "");
    }
    if (element.name == "face" && corner_lists != 1) {
      scanner.fail("the faces need one list vertex_indices", "");
    }
    if (element.name == "tristrips" && element.count > 0) {
      scanner.fail("triangle strips can't be read", "save the mesh with faces");
    }
  }
}

}  // namespace

PolygonSoup parse_ply(std::string_view data, const std::string& name, std::vector<Vec3>* normals) {
  LineScanner scanner(data, name);
  const Header header = parse_header(scanner);
  check_properties(header, scanner);
  long long points = 0;
  for (const Element& element : header.elements) {
    if (element.name == "vertex") points += element.count;
  }
  Body body(scanner, data, name, header.binary);
  const bool has_normals =
      std::any_of(header.elements.begin(), header.elements.end(), [](const Element& element) {
        return element.name == "vertex" &&
               std::any_of(element.properties.begin(), element.properties.end(),
                           [](const Property& property) { return is_axis(property, "n"); });
      });
  if (!has_normals) normals = nullptr;
  PolygonSoup soup;
  for (const Element& element : header.elements) {
    if (element.properties.empty())
      continue;  // the file stores nothing for these elements, whatever their count
    for (long long i = 0; i < element.count; ++i) {
      body.begin(element, i);
      if (element.name == "vertex") {
        read_point(body, element, soup, normals);
      } else if (element.name == "face") {
        read_polygon(body, element, points, soup);
      } else {
        for (const Property& property : element.properties) body.skip(property);
      }
    }
  }
  return soup;
}

std::string format_ply(const TriangleMesh& mesh, const MeshProperties& properties) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(mesh.points.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\n";
  if (!properties.colours.empty()) {
    bytes += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  }
  for (const MeshProperty& of : properties.points) bytes += "property float " + of.name + '\n';
  bytes += "element face " + std::to_string(mesh.triangles.size()) +
           "\nproperty list uchar int vertex_indices\n";
  for (const MeshProperty& of : properties.triangles) bytes += "property float " + of.name + '\n';
  bytes += "end_header\n";
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) store(bytes, mesh.points[i][axis]);
    if (!properties.colours.empty()) {
      const Colour& colour = properties.colours.at(i);
      for (const double channel : {colour.red, colour.green, colour.blue}) {
        store(bytes, static_cast<std::uint8_t>(std::lround(255 * std::clamp(channel, 0.0, 1.0))));
      }
    }
    for (const MeshProperty& of : properties.points) {
      store(bytes, static_cast<float>(of.values.at(i)));
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    store(bytes, std::uint8_t{3});
    for (const int corner : mesh.triangles[t]) store(bytes, static_cast<std::int32_t>(corner));
    for (const MeshProperty& of : properties.triangles) {
      store(bytes, static_cast<float>(of.values.at(t)));
    }
  }
  return bytes;
}

}  // namespace toile
