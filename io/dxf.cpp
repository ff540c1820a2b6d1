#include "io/dxf.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "geometry/error.h"
#include "io/dxf_curves.h"
#include "io/dxf_text.h"
#include "io/encoding.h"
#include "io/text.h"

namespace toile {

namespace {

constexpr double dxf_degree = std::numbers::pi / 180;

/// Units of a drawing: beyond, products of coordinates lose their digits.
constexpr double max_dxf_coordinate = 1e9;

/// Values of one entity: a polyline has some five for each vertex.
constexpr std::size_t max_groups = 2'000'000;

constexpr std::string_view binary_start = "AutoCAD Binary DXF";

std::string_view dxf_trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// A code and its value, two lines of the file.
struct DxfGroup {
  int code = 0;
  std::string_view value;
  int line = 0;  ///< of the value
};

/// The groups of a file, one after the other.
class DxfGroups {
 public:
  DxfGroups(std::string_view text, const std::string& name) : text_(text), name_(name) {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;
  }

  const DxfGroup& now() const { return now_; }
  bool is(int code, std::string_view value) const {
    return now_.code == code && dxf_trimmed(now_.value) == value;
  }

  void next() {
    do {
      const std::string_view code = dxf_trimmed(line("a group code"));
      const char* end = code.data() + code.size();
      const auto [stop, problem] = std::from_chars(code.data(), end, now_.code);
      if (problem != std::errc() || stop != end) {
        fail("'" + shown_text(code.substr(0, 20)) + "' is no group code",
             "the file is damaged or no DXF; save it again");
      }
      now_.value = line("the value of a group");
      now_.line = line_;
    } while (now_.code == 999);  // a comment
  }

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
    throw Error(name_ + ":" + std::to_string(line_), problem, remedy);
  }

 private:
  std::string_view line(const char* what) {
    if (at_ >= text_.size()) {
      fail("the file ends before " + std::string(what) + ", without an EOF",
           "it is cut off; save or copy it again");
    }
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    const std::string_view found = text_.substr(at_, end - at_);
    at_ = end + 1;
    if (end < text_.size() && text_[end] == '\r' && at_ < text_.size() && text_[at_] == '\n') ++at_;
    ++line_;
    return found;
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  int line_ = 0;
  DxfGroup now_;
};

/// The groups of one entity, from its type to the next one.
struct DxfRecord {
  std::string_view type;
  int line = 0;
  std::vector<DxfGroup> groups;
};

class DxfReader {
 public:
  DxfReader(std::string_view text, const std::string& name) : groups_(text, name), name_(name) {
    utf8_ = is_utf8(text);
  }

  DxfDrawing read() {
    groups_.next();
    while (!groups_.is(0, "EOF")) {
      if (!groups_.is(0, "SECTION")) {
        groups_.fail(
            "'" + shown_text(dxf_trimmed(groups_.now().value)) + "' stands where a section begins",
            "the file is damaged or no DXF; save it again");
      }
      groups_.next();
      if (groups_.is(2, "HEADER")) {
        header();
      } else if (groups_.is(2, "BLOCKS")) {
        blocks();
      } else if (groups_.is(2, "ENTITIES")) {
        groups_.next();
        entities(drawing_.entities);
      } else {
        while (!groups_.is(0, "ENDSEC")) groups_.next();
      }
      groups_.next();
    }
    name_blocks();
    return std::move(drawing_);
  }

 private:
  [[noreturn]] void fail(int line, const std::string& problem,
                         const std::string& remedy = "correct the entity or remove it") const {
    throw Error(name_ + ":" + std::to_string(line), problem, remedy);
  }

  double number(const DxfGroup& group) const {
    const auto value = parse_number(dxf_trimmed(group.value));
    if (!value || !std::isfinite(*value)) {
      fail(group.line, "'" + shown_text(group.value.substr(0, 40)) + "' is no number",
           "the file is damaged; save it again");
    }
    return *value;
  }

  double coordinate(const DxfGroup& group) const {
    const double value = number(group);
    if (std::abs(value) > max_dxf_coordinate) {
      fail(group.line, "a coordinate is " + number_text(value) + ", beyond 1,000,000,000 units");
    }
    return value;
  }

  double bulge(const DxfGroup& group) const {
    const double value = number(group);
    if (std::abs(value) > 1e4) fail(group.line, "a bulge is " + number_text(value));
    return value;
  }

  int integer(const DxfGroup& group) const {
    return static_cast<int>(std::clamp(number(group), -1e9, 1e9));
  }

  std::string text(std::string_view value) const {
    return utf8_ ? std::string(value) : to_utf8(value, code_page_);
  }

  void header() {
    std::string_view variable;
    for (groups_.next(); !groups_.is(0, "ENDSEC"); groups_.next()) {
      const DxfGroup& group = groups_.now();
      const std::string_view value = dxf_trimmed(group.value);
      if (group.code == 9) {
        variable = value;
      } else if (variable == "$ACADVER") {
        drawing_.version = valid_utf8(value);
      } else if (variable == "$DWGCODEPAGE") {
        const std::size_t mark = value.find_last_of("_- ");
        const std::string_view page =
            mark == std::string_view::npos ? value : value.substr(mark + 1);
        code_page_ = "CP" + valid_utf8(page);
        if (value.substr(0, 3) == "DOS") code_page_ = "CP" + valid_utf8(value.substr(3));
      } else if (variable == "$INSUNITS" && group.code == 70) {
        drawing_.unit_metres = unit(integer(group));
      } else if (variable == "$MEASUREMENT" && group.code == 70) {
        drawing_.measurement =
            integer(group) == 0 ? DxfMeasurement::english : DxfMeasurement::metric;
      }
    }
  }

  static double unit(int code) {
    const std::map<int, double> metres = {{1, 0.0254}, {2, 0.3048},  {4, 1e-3},    {5, 1e-2},
                                          {6, 1},      {8, 2.54e-8}, {9, 2.54e-5}, {10, 0.9144},
                                          {13, 1e-6},  {14, 0.1}};
    const auto found = metres.find(code);
    return found == metres.end() ? 0 : found->second;
  }

  /// The groups up to the next code 0.
  DxfRecord record() {
    DxfRecord record{dxf_trimmed(groups_.now().value), groups_.now().line, {}};
    for (groups_.next(); groups_.now().code != 0; groups_.next()) {
      if (record.groups.size() == max_groups) {
        fail(record.line, "an entity has more than " + std::to_string(max_groups) + " values");
      }
      record.groups.push_back(groups_.now());
    }
    return record;
  }

  void blocks() {
    groups_.next();
    while (!groups_.is(0, "ENDSEC")) {
      if (!groups_.is(0, "BLOCK")) {
        groups_.fail(
            "'" + shown_text(dxf_trimmed(groups_.now().value)) + "' stands where a block begins",
            "the file is damaged; save it again");
      }
      const DxfRecord head = record();
      DxfBlock block;
      block.line = head.line;
      Vec2 base = Vec2::Zero();
      for (const DxfGroup& group : head.groups) {
        if (group.code == 2) block.name = text(dxf_trimmed(group.value));
        if (group.code == 10) base.x() = coordinate(group);
        if (group.code == 20) base.y() = coordinate(group);
      }
      entities(block.entities);
      if (!groups_.is(0, "ENDBLK")) groups_.fail("a block has no end", "save the file again");
      record();
      count_entity(block.line);
      std::string upper = block.name;
      for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      if (upper == "*MODEL_SPACE" || upper == "$MODEL_SPACE") {
        drawing_.entities.insert(drawing_.entities.end(), block.entities.begin(),
                                 block.entities.end());
      } else if (upper.rfind("*PAPER_SPACE", 0) != 0 && upper.rfind("$PAPER_SPACE", 0) != 0) {
        drawing_.blocks.push_back(std::move(block));
        bases_.push_back(base);
      }
    }
  }

  void entities(std::vector<DxfEntity>& list) {
    while (!groups_.is(0, "ENDSEC") && !groups_.is(0, "ENDBLK")) {
      if (groups_.is(0, "EOF") || groups_.is(0, "SECTION")) {
        groups_.fail("a section has no end", "the file is damaged; save it again");
      }
      if (groups_.now().code != 0) {
        groups_.next();
        continue;
      }
      entity(record(), list);
    }
  }

  void count_entity(int line) {
    if (++entities_ > max_dxf_entities) {
      fail(line, "the file has more than " + std::to_string(max_dxf_entities) + " entities",
           "is it really a pattern? keep the layers of the pieces only");
    }
  }

  void count_curves(int line, std::size_t count) {
    curves_ += count;
    if (curves_ > static_cast<std::size_t>(max_dxf_curves)) {
      fail(line, "the file has more than " + std::to_string(max_dxf_curves) + " sides of curves",
           "is it really a pattern? keep the layers of the pieces only");
    }
  }

  void ignore(std::string_view type) { ++drawing_.ignored[valid_utf8(type.substr(0, 40))]; }

  void entity(const DxfRecord& record, std::vector<DxfEntity>& list) {
    count_entity(record.line);
    DxfEntity entity;
    entity.type = valid_utf8(record.type.substr(0, 40));
    entity.line = record.line;
    bool paper = false;
    double tilt = 1;
    for (const DxfGroup& group : record.groups) {
      if (group.code == 8) entity.layer = text(dxf_trimmed(group.value));
      if (group.code == 67) paper = integer(group) == 1;
      if (group.code == 230) tilt = number(group);
    }
    // Entities are drawn in the plane, or in the plane as seen from behind.
    const bool flat = std::abs(std::abs(tilt) - 1) < 1e-6;
    const bool behind = flat && tilt < 0;
    bool known = flat && !paper;
    const std::string_view type = record.type;
    if (type == "POLYLINE") {
      known = polyline(record, entity) && known;
    } else if (type == "LWPOLYLINE") {
      lightweight_polyline(record, entity);
    } else if (type == "LINE") {
      line(record, entity);
    } else if (type == "ARC" || type == "CIRCLE") {
      arc(record, entity);
    } else if (type == "ELLIPSE") {
      ellipse(record, entity, behind);
    } else if (type == "SPLINE") {
      spline(record, entity);
    } else if (type == "POINT" || type == "TEXT" || type == "MTEXT" || type == "ATTRIB" ||
               type == "ATTDEF") {
      mark(record, entity);
    } else if (type == "INSERT") {
      if (known) insert(record, entity, behind, list);
      attributes(record, list);
      if (known) return;
    } else {
      known = false;
    }
    if (!known) {
      // What belongs to an entity that was ignored, and says nothing itself, is not counted.
      if (type != "SEQEND" && type != "VERTEX") {
        ignore(paper ? "of paper space" : flat ? type : "tilted out of the plane");
      }
      return;
    }
    const bool in_own_plane =
        type != "LINE" && type != "POINT" && type != "ELLIPSE" && type != "SPLINE";
    if (behind && in_own_plane) {
      entity = transformed(entity, Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
    }
    if (entity.kind == DxfEntity::Kind::curves) {
      if (entity.curves.empty()) return;
      count_curves(entity.line, entity.curves.size());
    }
    list.push_back(std::move(entity));
  }

  struct Vertex {
    Vec2 at = Vec2::Zero();
    double bulge = 0;
  };

  static void join(const std::vector<Vertex>& vertices, bool closed, DxfEntity& entity) {
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      append_dxf_bulge(entity.curves, vertices[i].at, vertices[i + 1].at, vertices[i].bulge);
    }
    if (closed && vertices.size() > 1 && vertices.back().at != vertices.front().at) {
      append_dxf_bulge(entity.curves, vertices.back().at, vertices.front().at,
                       vertices.back().bulge);
    }
  }

  /// Reads the vertices behind the head, too. False for meshes in space.
  bool polyline(const DxfRecord& head, DxfEntity& entity) {
    int flags = 0;
    for (const DxfGroup& group : head.groups) {
      if (group.code == 70) flags = integer(group);
    }
    constexpr int closed = 1;
    constexpr int spline_fitted = 4;
    constexpr int meshes = 16 + 64;
    constexpr int control_point = 16;
    std::vector<Vertex> vertices;
    while (groups_.is(0, "VERTEX")) {
      const DxfRecord record = this->record();
      count_curves(record.line, 1);
      Vertex vertex;
      int own_flags = 0;
      for (const DxfGroup& group : record.groups) {
        if (group.code == 10) vertex.at.x() = coordinate(group);
        if (group.code == 20) vertex.at.y() = coordinate(group);
        if (group.code == 42) vertex.bulge = bulge(group);
        if (group.code == 70) own_flags = integer(group);
      }
      if ((flags & spline_fitted) != 0 && (own_flags & control_point) != 0) continue;
      vertices.push_back(vertex);
    }
    if (groups_.is(0, "SEQEND")) record();
    if ((flags & meshes) != 0) return false;
    join(vertices, (flags & closed) != 0, entity);
    return true;
  }

  void lightweight_polyline(const DxfRecord& record, DxfEntity& entity) const {
    std::vector<Vertex> vertices;
    bool closed = false;
    for (const DxfGroup& group : record.groups) {
      if (group.code == 70) closed = (integer(group) & 1) != 0;
      if (group.code == 10) {
        vertices.emplace_back();
        vertices.back().at.x() = coordinate(group);
      }
      if (vertices.empty()) continue;
      if (group.code == 20) vertices.back().at.y() = coordinate(group);
      if (group.code == 42) vertices.back().bulge = bulge(group);
    }
    join(vertices, closed, entity);
  }

  void line(const DxfRecord& record, DxfEntity& entity) const {
    Vec2 start = Vec2::Zero();
    Vec2 end = Vec2::Zero();
    for (const DxfGroup& group : record.groups) {
      if (group.code == 10) start.x() = coordinate(group);
      if (group.code == 20) start.y() = coordinate(group);
      if (group.code == 11) end.x() = coordinate(group);
      if (group.code == 21) end.y() = coordinate(group);
    }
    entity.curves.push_back(dxf_line(start, end));
  }

  void arc(const DxfRecord& record, DxfEntity& entity) const {
    double radius = 0;
    double from = 0;
    double to = 360;
    for (const DxfGroup& group : record.groups) {
      if (group.code == 10) entity.at.x() = coordinate(group);
      if (group.code == 20) entity.at.y() = coordinate(group);
      if (group.code == 40) radius = coordinate(group);
      if (group.code == 50) from = number(group);
      if (group.code == 51) to = number(group);
    }
    if (!(radius > 0)) fail(record.line, "an arc's radius is " + number_text(radius));
    from = std::remainder(from, 360);
    to = from + std::fmod(std::fmod(to - from, 360) + 360, 360);
    if (record.type == "CIRCLE" || to == from) to = from + 360;
    append_dxf_arc(entity.curves, entity.at, Vec2(radius, 0), Vec2(0, radius), from * dxf_degree,
                   to * dxf_degree);
    if (record.type == "CIRCLE") entity.curves.back().points[3] = entity.curves.front().points[0];
  }

  void ellipse(const DxfRecord& record, DxfEntity& entity, bool behind) const {
    Vec2 major = Vec2::Zero();
    double ratio = 1;
    double from = 0;
    double to = 2 * std::numbers::pi;
    for (const DxfGroup& group : record.groups) {
      if (group.code == 10) entity.at.x() = coordinate(group);
      if (group.code == 20) entity.at.y() = coordinate(group);
      if (group.code == 11) major.x() = coordinate(group);
      if (group.code == 21) major.y() = coordinate(group);
      if (group.code == 40) ratio = number(group);
      if (group.code == 41) from = number(group);
      if (group.code == 42) to = number(group);
    }
    if (major.squaredNorm() == 0 || !(std::abs(ratio) <= 1)) fail(record.line, "is no ellipse");
    constexpr double turn = 2 * std::numbers::pi;
    from = std::remainder(from, turn);
    to = from + std::fmod(std::fmod(to - from, turn) + turn, turn);
    if (to - from < 1e-9) to = from + turn;
    const Vec2 minor = (behind ? -ratio : ratio) * Vec2(-major.y(), major.x());
    append_dxf_arc(entity.curves, entity.at, major, minor, from, to);
  }

  void spline(const DxfRecord& record, DxfEntity& entity) {
    DxfSpline spline;
    for (const DxfGroup& group : record.groups) {
      const auto last = [&](std::vector<Vec2>& points) -> Vec2& {
        if (points.empty()) points.emplace_back(Vec2::Zero());
        return points.back();
      };
      switch (group.code) {
        case 71:
          spline.degree = integer(group);
          break;
        case 40:
          spline.knots.push_back(number(group));
          break;
        case 41:
          spline.weights.push_back(number(group));
          break;
        case 10:
          spline.control_points.emplace_back(coordinate(group), 0);
          break;
        case 20:
          last(spline.control_points).y() = coordinate(group);
          break;
        case 11:
          spline.fit_points.emplace_back(coordinate(group), 0);
          break;
        case 21:
          last(spline.fit_points).y() = coordinate(group);
          break;
        default:
          break;
      }
    }
    const std::string problem = spline_problem(spline);
    if (!problem.empty()) fail(record.line, "a spline " + problem);
    count_curves(record.line, 16 * (spline.control_points.size() + spline.fit_points.size()));
    entity.curves = spline_curves(spline);
  }

  /// A point or a text.
  void mark(const DxfRecord& record, DxfEntity& entity) const {
    const bool paragraphs = record.type == "MTEXT";
    entity.kind = record.type == "POINT" ? DxfEntity::Kind::point : DxfEntity::Kind::text;
    std::string content;
    for (const DxfGroup& group : record.groups) {
      if (group.code == 10) entity.at.x() = coordinate(group);
      if (group.code == 20) entity.at.y() = coordinate(group);
      if (group.code == 50) {
        entity.angle = std::remainder(number(group), 360) * dxf_degree;
        entity.has_angle = true;
      }
      if (group.code == 1 || (paragraphs && group.code == 3)) content += text(group.value);
    }
    if (entity.kind == DxfEntity::Kind::point) return;
    entity.text = paragraphs ? plain_dxf_paragraphs(content) : plain_dxf_text(content);
  }

  /// The attributes behind an insert are texts.
  void attributes(const DxfRecord& head, std::vector<DxfEntity>& list) {
    bool follow = false;
    for (const DxfGroup& group : head.groups)
      follow = follow || (group.code == 66 && integer(group) == 1);
    if (!follow) return;
    while (groups_.is(0, "ATTRIB")) entity(record(), list);
    if (groups_.is(0, "SEQEND")) record();
  }

  void insert(const DxfRecord& record, DxfEntity entity, bool behind,
              std::vector<DxfEntity>& list) {
    entity.kind = DxfEntity::Kind::insert;
    Vec2 scale(1, 1);
    Vec2 step(0, 0);
    int columns = 1;
    int rows = 1;
    for (const DxfGroup& group : record.groups) {
      if (group.code == 2) entity.text = text(dxf_trimmed(group.value));
      if (group.code == 10) entity.at.x() = coordinate(group);
      if (group.code == 20) entity.at.y() = coordinate(group);
      if (group.code == 41) scale.x() = coordinate(group);
      if (group.code == 42) scale.y() = coordinate(group);
      if (group.code == 44) step.x() = coordinate(group);
      if (group.code == 45) step.y() = coordinate(group);
      if (group.code == 50) entity.angle = std::remainder(number(group), 360) * dxf_degree;
      if (group.code == 70) columns = std::max(1, integer(group));
      if (group.code == 71) rows = std::max(1, integer(group));
    }
    if (scale.x() == 0 || scale.y() == 0) fail(record.line, "an insert has the scale 0");
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        if (row + column > 0) count_entity(record.line);
        Eigen::Affine2d placed = Eigen::Affine2d::Identity();
        if (behind) placed.scale(Vec2(-1, 1));
        placed.translate(entity.at);
        placed.rotate(entity.angle);
        placed.translate(Vec2(column * step.x(), row * step.y()));
        placed.scale(scale);
        entity.placed = placed;
        list.push_back(entity);
      }
    }
  }

  /// Inserts know blocks by name until all blocks are read.
  void name_blocks() {
    std::map<std::string, std::vector<int>> named;
    for (std::size_t i = 0; i < drawing_.blocks.size(); ++i) {
      named[drawing_.blocks[i].name].push_back(static_cast<int>(i));
    }
    std::map<std::string, std::size_t> turn;
    const auto resolve = [&](std::vector<DxfEntity>& list) {
      std::erase_if(list, [&](DxfEntity& entity) {
        if (entity.kind != DxfEntity::Kind::insert) return false;
        const auto found = named.find(entity.text);
        if (found == named.end()) {
          ignore("INSERT of a missing block");
          return true;
        }
        const std::size_t which = turn[entity.text]++ % found->second.size();
        entity.block = found->second[which];
        entity.placed.translate(-bases_[static_cast<std::size_t>(entity.block)]);
        return false;
      });
    };
    resolve(drawing_.entities);
    for (DxfBlock& block : drawing_.blocks) resolve(block.entities);
  }

  DxfGroups groups_;
  const std::string& name_;
  DxfDrawing drawing_;
  std::vector<Vec2> bases_;  ///< of blocks: the points that inserts place
  std::string code_page_ = "CP1252";
  bool utf8_ = false;
  int entities_ = 0;
  std::size_t curves_ = 0;
};

}  // namespace

bool looks_like_dxf(std::string_view text) {
  if (text.substr(0, binary_start.size()) == binary_start) return true;
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  const std::size_t end = text.find_first_of("\r\n");
  if (end == std::string_view::npos) return false;
  const std::string_view code = dxf_trimmed(text.substr(0, end));
  if (code == "999") return true;
  const std::string_view rest = text.substr(end, 40);
  return code == "0" && dxf_trimmed(rest).substr(0, 7) == "SECTION";
}

DxfDrawing parse_dxf(std::string_view text, const std::string& name) {
  if (text.substr(0, binary_start.size()) == binary_start) {
    throw Error(name, "is a binary DXF",
                "save it as text: in the CAD program choose DXF of R12 to 2013 as ASCII");
  }
  if (text.substr(0, 3) == "AC1") {
    throw Error(name, "is a DWG file", "save it as DXF, of R12 to 2013 as ASCII");
  }
  if (text.size() > max_dxf_bytes) {
    throw Error(name, "has more than " + std::to_string(max_dxf_bytes >> 20) + " MB",
                "is it really a pattern? keep the layers of the pieces only");
  }
  return DxfReader(text, name).read();
}

DxfEntity transformed(const DxfEntity& entity, const Eigen::Affine2d& placed) {
  DxfEntity moved = entity;
  for (DxfCurve& curve : moved.curves) {
    for (Vec2& point : curve.points) point = placed * point;
  }
  moved.at = placed * entity.at;
  const Vec2 along = placed.linear() * Vec2(std::cos(entity.angle), std::sin(entity.angle));
  if (along.squaredNorm() > 0) moved.angle = std::atan2(along.y(), along.x());
  moved.placed = placed * entity.placed;
  return moved;
}

}  // namespace toile
