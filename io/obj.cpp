#include "io/obj.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <unordered_map>

#include "geometry/error.h"
#include "io/limits.h"
#include "io/line_scanner.h"
#include "io/output_file.h"
#include "io/text.h"

namespace toile {

namespace {

bool is_separator(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_separator(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_separator(text.back())) text.remove_suffix(1);
  return text;
}

/// Removes the first word from `rest` and returns it; empty when there is none.
std::string_view next_word(std::string_view& rest) {
  while (!rest.empty() && is_separator(rest.front())) rest.remove_prefix(1);
  std::size_t end = 0;
  while (end < rest.size() && !is_separator(rest[end])) ++end;
  const std::string_view word = rest.substr(0, end);
  rest.remove_prefix(end);
  return word;
}

class Parser {
 public:
  Parser(const std::string& text, const std::string& name, double max)
      : text_(text), name_(name), max_(max) {}

  ObjData parse() {
    std::size_t at = 0;
    std::string joined;
    while (at < text_.size()) {
      ++line_;
      std::string_view line = take_line(at);
      // A backslash at the end of a line continues it on the next.
      if (!line.empty() && line.back() == '\\') {
        joined.clear();
        const int first = line_;
        while (!line.empty() && line.back() == '\\') {
          joined += line.substr(0, line.size() - 1);
          joined += ' ';
          if (at >= text_.size()) {
            line = {};
            break;
          }
          ++line_;
          line = take_line(at);
        }
        joined += line;
        const int last = line_;
        line_ = first;
        statement(joined);
        line_ = last;
      } else {
        statement(line);
      }
    }
    if (statements_ == 0) {
      throw Error(name_, "holds no OBJ statement", "is it really a Wavefront OBJ file?");
    }
    check_ranges();
    return std::move(data_);
  }

 private:
  std::string_view take_line(std::size_t& at) const {
    const std::size_t end = std::min(text_.find('\n', at), text_.size());
    const std::string_view line = trimmed(std::string_view(text_).substr(at, end - at));
    at = end + 1;
    return line;
  }

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy = "") const {
    throw Error(name_ + ":" + std::to_string(line_), problem, remedy);
  }

  double number(std::string_view word) const {
    if (word.empty()) fail("a number is missing");
    const std::optional<double> value = parse_number(word);
    if (!value) fail(shown(word) + " is not a number");
    if (!std::isfinite(*value)) fail(shown(word) + " is not a finite number");
    const std::string problem = coordinate_problem(*value, max_);
    if (!problem.empty()) fail(problem, coordinate_remedy);
    return *value;
  }

  /// An index of the file as an index from 0. The file counts from 1, or from -1 backward from the
  /// last item so far.
  int index(std::string_view word, std::size_t so_far, std::string_view of) const {
    long long value = 0;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
    if (read.ec != std::errc() || read.ptr != word.data() + word.size()) {
      fail(shown(word) + " is not an index");
    }
    if (value < 0) value += static_cast<long long>(so_far) + 1;
    if (value < 1 || value > std::numeric_limits<int>::max()) {
      fail(shown(word) + " is no " + std::string(of), "indices count from 1");
    }
    return static_cast<int>(value - 1);
  }

  ObjCorner corner(std::string_view word) const {
    ObjCorner corner;
    const std::size_t slash = word.find('/');
    corner.point = index(word.substr(0, slash), data_.points.size(), "vertex of this file");
    if (slash != std::string_view::npos) {
      const std::string_view rest = word.substr(slash + 1);
      const std::string_view texture = rest.substr(0, rest.find('/'));
      if (!texture.empty()) {
        corner.texture = index(texture, data_.texture.size(), "texture coordinate of this file");
      }
    }
    return corner;
  }

  void face(std::string_view rest) {
    ObjFace face;
    for (auto word = next_word(rest); !word.empty(); word = next_word(rest)) {
      face.corners.push_back(corner(word));
      if (face.corners.size() > max_face_corners) {
        fail("a face has more than " + std::to_string(max_face_corners) + " corners",
             "cut it into triangles");
      }
    }
    if (face.corners.size() < 3) fail("a face has fewer than three corners");
    face.group = group();
    data_.faces.push_back(std::move(face));
    face_lines_.push_back(line_);
  }

  void polyline(std::string_view rest) {
    int previous = -1;
    int corners = 0;
    for (auto word = next_word(rest); !word.empty(); word = next_word(rest)) {
      const int point = corner(word).point;
      if (corners++ > 0) {
        data_.lines.push_back({previous, point});
        line_lines_.push_back(line_);
      }
      previous = point;
    }
    if (corners < 2) fail("a line has fewer than two points");
  }

  int group() {
    if (group_name_.empty()) return -1;
    const auto [found, added] =
        groups_.try_emplace(group_name_, static_cast<int>(data_.groups.size()));
    if (added) data_.groups.push_back(group_name_);
    return found->second;
  }

  void statement(std::string_view line) {
    line = trimmed(line.substr(0, line.find('#')));
    std::string_view rest = line;
    const std::string_view keyword = next_word(rest);
    if (keyword.empty()) return;
    if (keyword == "v") {
      Vec3 point;
      for (int i = 0; i < 3; ++i) point[i] = number(next_word(rest));
      data_.points.push_back(point);
    } else if (keyword == "vt") {
      Vec2 texture(number(next_word(rest)), 0);
      if (const auto word = next_word(rest); !word.empty()) texture.y() = number(word);
      data_.texture.push_back(texture);
    } else if (keyword == "f") {
      face(rest);
    } else if (keyword == "l") {
      polyline(rest);
    } else if (keyword == "g" || keyword == "o") {
      group_name_ = trimmed(rest);
    } else if (keyword != "vn" && keyword != "s" && keyword != "usemtl" && keyword != "mtllib") {
      return;
    }
    ++statements_;
  }

  /// Checks indices. Indices may point forward in the file, so this comes when all of it is read.
  void check_ranges() {
    const auto check = [this](int value, std::size_t count, const char* what) {
      if (value >= static_cast<int>(count)) {
        fail("refers to " + std::string(what) + " " + std::to_string(value + 1LL) +
             ", but the file holds " + std::to_string(count));
      }
    };
    for (std::size_t f = 0; f < data_.faces.size(); ++f) {
      line_ = face_lines_[f];
      for (const ObjCorner& corner : data_.faces[f].corners) {
        check(corner.point, data_.points.size(), "vertex");
        check(corner.texture, data_.texture.size(), "texture coordinate");
      }
    }
    for (std::size_t l = 0; l < data_.lines.size(); ++l) {
      line_ = line_lines_[l];
      for (const int point : data_.lines[l]) check(point, data_.points.size(), "vertex");
    }
  }

  const std::string& text_;
  const std::string& name_;
  double max_;  // of coordinates
  ObjData data_;
  std::string group_name_;
  std::unordered_map<std::string, int> groups_;
  std::vector<int> face_lines_;
  std::vector<int> line_lines_;
  int line_ = 0;
  int statements_ = 0;
};

void append_coordinate(std::string& text, double value) {
  text += ' ';
  append_number(text, value);
}

/// Appends an index as the file counts, from 1.
void append_index(std::string& text, int index) { text += std::to_string(index + 1LL); }

/// A name on one line, with '_' for characters that would not read back as part of it.
std::string one_line(std::string_view name) {
  std::string text(trimmed(name));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '#' || c == '\\') c = '_';
  }
  return text;
}

void append_group(std::string& text, const ObjData& data, int group) {
  if (group < 0) {
    text += "g\n";
    return;
  }
  const auto g = static_cast<std::size_t>(group);
  const std::string name = one_line(data.groups.at(g));
  if (data.materials.empty()) {
    text.append("g ").append(name).append("\n");
  } else {
    text.append("o ").append(name).append("\nusemtl ");
    text.append(one_line(data.materials.at(g))).append("\n");
  }
}

}  // namespace

ObjData parse_obj(const std::string& text, const std::string& name, double max) {
  return Parser(text, name, max).parse();
}

ObjData read_obj(const std::filesystem::path& path, double max) {
  return parse_obj(read_file(path), path.string(), max);
}

std::string format_obj(const ObjData& data) {
  std::string text;
  for (const std::string& comment : data.comments) text += "# " + one_line(comment) + "\n";
  for (const Vec3& point : data.points) {
    text += 'v';
    for (int i = 0; i < 3; ++i) append_coordinate(text, point[i]);
    text += '\n';
  }
  for (const Vec2& texture : data.texture) {
    text += "vt";
    for (int i = 0; i < 2; ++i) append_coordinate(text, texture[i]);
    text += '\n';
  }
  for (const Vec3& normal : data.normals) {
    text += "vn";
    for (int i = 0; i < 3; ++i) append_coordinate(text, std::round(1e6 * normal[i]) / 1e6);
    text += '\n';
  }
  int group = -1;
  for (const ObjFace& face : data.faces) {
    if (face.group != group) {
      group = face.group;
      append_group(text, data, group);
    }
    text += 'f';
    for (const ObjCorner& corner : face.corners) {
      text += ' ';
      append_index(text, corner.point);
      if (corner.texture >= 0) {
        text += '/';
        append_index(text, corner.texture);
      }
      if (!data.normals.empty()) {
        text += corner.texture >= 0 ? "/" : "//";
        append_index(text, corner.point);
      }
    }
    text += '\n';
  }
  for (const auto& [from, to] : data.lines) {
    text += "l ";
    append_index(text, from);
    text += ' ';
    append_index(text, to);
    text += '\n';
  }
  return text;
}

void write_obj(const OutputPath& path, const ObjData& data) { write_file(path, format_obj(data)); }

}  // namespace toile
