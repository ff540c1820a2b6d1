#include "io/point_file.h"

#include <Eigen/LU>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "geometry/error.h"
#include "io/limits.h"
#include "io/line_scanner.h"
#include "io/mesh_file.h"
#include "io/mesh_formats.h"
#include "io/obj.h"
#include "io/output_file.h"
#include "io/text.h"

namespace toile {

namespace {

namespace fs = std::filesystem;

constexpr int most_columns = 9;  // that are looked at

std::string extension_of(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// What a comma in a table is.
enum class Comma { gap, decimal };

bool is_column_gap(char c, Comma comma) {
  return c == ' ' || c == '\t' || c == ';' || (c == ',' && comma == Comma::gap);
}

/// Removes the first word from `rest`; empty at its end.
std::string_view next_column(std::string_view& rest, Comma comma) {
  while (!rest.empty() && is_column_gap(rest.front(), comma)) rest.remove_prefix(1);
  std::size_t end = 0;
  while (end < rest.size() && !is_column_gap(rest[end], comma)) ++end;
  std::string_view word = rest.substr(0, end);
  rest.remove_prefix(end);
  // "1,5, 2,5, 3,5": one before a gap separates.
  if (comma == Comma::decimal && word.size() > 1 && word.back() == ',') word.remove_suffix(1);
  return word;
}

/// The numbers of a line.
struct Columns {
  std::array<double, most_columns> value{};
  int count = 0;
  bool is_whole = true;  // the first is written as a whole number

  Vec3 triple(int first) const { return {value[first], value[first + 1], value[first + 2]}; }
};

/// The line without its comment.
std::string_view content_of(std::string_view line) {
  return line.substr(0, std::min(line.find('#'), line.find("//")));
}

/// Reads "0,25" as 0.25 where commas are decimal.
std::optional<double> parse_column(std::string_view word, Comma comma) {
  if (comma == Comma::gap || word.find(',') == word.npos) return parse_number(word);
  if (word.find(',') != word.rfind(',')) return std::nullopt;
  std::string pointed(word);
  pointed[pointed.find(',')] = '.';
  return parse_number(pointed);
}

/// What a line of coordinates tells of its commas; nothing where it has none. They are decimal if
/// gaps of other kinds leave three numbers, of which none has a point or a second comma.
std::optional<Comma> comma_of(std::string_view line) {
  bool any = false;
  for (int column = 0; column < 3; ++column) {
    const std::string_view word = next_column(line, Comma::decimal);
    const std::size_t comma = word.find(',');
    if (comma == word.npos && !word.empty() && word.find('.') == word.npos) continue;
    if (comma == word.npos) return any ? std::optional(Comma::gap) : std::nullopt;
    const auto is_digit = [&](std::size_t i) {
      return i < word.size() && std::isdigit(static_cast<unsigned char>(word[i])) != 0;
    };
    if (comma == 0 || !is_digit(comma - 1) || !is_digit(comma + 1) ||
        !parse_column(word, Comma::decimal) || word.find('.') != word.npos) {
      return Comma::gap;
    }
    any = true;
  }
  return any ? std::optional(Comma::decimal) : std::nullopt;
}

/// Whether the word is the end of a number that was cut at a decimal comma, or its beginning:
/// "0846" or "-0" of "-0,0846". One in ten of them shows it.
bool is_fraction_alone(std::string_view word) {
  if (word == "-0") return true;
  return word.size() > 1 && word.front() == '0' &&
         word.find_first_not_of("0123456789") == word.npos;
}

/// The line's numbers; nothing for a heading, which only the first line can be.
std::optional<Columns> read_columns(const LineScanner& scanner, bool is_first, Comma comma) {
  Columns columns;
  std::string_view rest = content_of(scanner.rest());
  for (std::string_view word = next_column(rest, comma);
       !word.empty() && columns.count < most_columns; word = next_column(rest, comma)) {
    const std::optional<double> value = parse_column(word, comma);
    if (!value) {
      if (is_first && columns.count == 0) return std::nullopt;
      if (columns.count < 3) scanner.fail(shown(word) + " is not a number", "");
      break;  // a name or a note after the coordinates
    }
    if (comma == Comma::gap && columns.count < 3 && is_fraction_alone(word)) {
      scanner.fail(shown(word) +
                       " is no number that programs write: do commas part both digits and columns?",
                   "write decimal points, or semicolons between columns");
    }
    if (columns.count == 0) columns.is_whole = word.find_first_not_of("0123456789") == word.npos;
    columns.value[columns.count++] = *value;
  }
  return columns;
}

/// Whether the triples from column `first` on are directions, or missing, so far.
class NormalColumns {
 public:
  explicit NormalColumns(int first) : first_(first) {}
  void add(const Columns& columns) {
    if (!possible_) return;
    possible_ = columns.count >= first_ + 3;
    if (!possible_) return;
    const Vec3 normal = columns.triple(first_);
    const double length = normal.norm();
    possible_ = length == 0 || std::abs(length - 1) < 0.02;
    normals_.push_back(length > 0 ? Vec3(normal / length) : normal);
  }
  bool possible() const { return possible_ && !normals_.empty(); }
  std::vector<Vec3>& normals() { return normals_; }

 private:
  int first_;
  bool possible_ = true;
  std::vector<Vec3> normals_;
};

}  // namespace

bool is_point_table(const fs::path& path) {
  const std::string extension = extension_of(path);
  return extension == ".xyz" || extension == ".pts" || extension == ".asc" || extension == ".txt" ||
         extension == ".csv";
}

PointCloud parse_points(std::string_view data, const std::string& name) {
  LineScanner scanner(data, name);
  PointCloud cloud;
  NormalColumns fourth(3);
  NormalColumns seventh(6);
  bool counted = false;
  double announced = 0;
  std::optional<Comma> comma;  // the same in all lines, by the first that tells
  for (bool is_first = true; scanner.next_line(); is_first = false) {
    const std::optional<Comma> told = comma ? comma : comma_of(content_of(scanner.rest()));
    const std::optional<Columns> columns =
        read_columns(scanner, is_first, told.value_or(Comma::gap));
    if (columns && columns->count >= 3) comma = told;
    if (!columns || columns->count == 0) continue;
    if (columns->count == 1 && columns->is_whole) {
      if (static_cast<double>(cloud.points.size()) != announced) break;
      counted = true;
      announced += columns->value[0];
      continue;
    }
    if (columns->count < 3) {
      scanner.fail("has " + std::to_string(columns->count) + " of the numbers x, y and z",
                   "is it really a table of points?");
    }
    for (int axis = 0; axis < 3; ++axis) {
      const std::string problem = coordinate_problem(columns->value[axis]);
      if (!problem.empty()) scanner.fail(problem, coordinate_remedy);
    }
    cloud.points.push_back(columns->triple(0));
    fourth.add(*columns);
    seventh.add(*columns);
  }
  if (counted && static_cast<double>(cloud.points.size()) != announced) {
    scanner.fail("the file announces " + number_text(announced, 12) +
                     " points up to here and has " + std::to_string(cloud.points.size()),
                 "is it cut off?");
  }
  if (fourth.possible()) {
    cloud.normals = std::move(fourth.normals());
  } else if (seventh.possible()) {
    cloud.normals = std::move(seventh.normals());
  }
  return cloud;
}

BodyFile read_body_file(const fs::path& path) {
  BodyFile file;
  const std::string name = path.string();
  if (is_point_table(path)) {
    PointCloud cloud = parse_points(read_file(path), name);
    file.soup.points = std::move(cloud.points);
    file.normals = std::move(cloud.normals);
  } else if (extension_of(path) == ".ply") {
    file.soup = parse_ply(read_file(path), name, &file.normals);
  } else {
    file.soup = read_polygons(path);
  }
  if (file.soup.points.empty()) {
    throw Error(name, "holds no points", "export the body as a surface, or as points");
  }
  return file;
}

Eigen::Matrix4d read_scan_pose(const fs::path& path) {
  const std::string text = read_file(path);
  LineScanner scanner(text, path.string());
  Eigen::Matrix4d pose;
  for (int row = 0; row < 4; ++row) {
    scanner.need_line("row " + std::to_string(row + 1) + " of the pose's four", '#');
    for (int column = 0; column < 4; ++column) {
      pose(row, column) = scanner.number("column " + std::to_string(column + 1) + " of the pose");
    }
    if (!scanner.word().empty()) {
      scanner.fail("has more than four numbers", "a pose has four rows of four numbers");
    }
  }
  if (scanner.next_line('#')) {
    scanner.fail("is a fifth row", "a pose has four rows of four numbers");
  }
  const Eigen::Matrix3d turn = pose.topLeftCorner<3, 3>();
  const bool is_rotation = (turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-3 &&
                           turn.determinant() > 0;
  if (!is_rotation || pose.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
    scanner.fail("the pose is no rotation with a translation",
                 "give four rows of four numbers, the last of them 0 0 0 1");
  }
  return pose;
}

}  // namespace toile
