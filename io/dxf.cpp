#include "io/dxf.h"

#include <algorithm>
#include <cmath>

#include "geometry/angles.h"
#include "geometry/error.h"
#include "io/dxf_curves.h"
#include "io/dxf_entities.h"
#include "io/dxf_groups.h"
#include "io/dxf_text.h"
#include "io/encoding.h"
#include "io/text.h"

namespace toile {

namespace {

constexpr std::string_view binary_start = "AutoCAD Binary DXF";

class DxfReader {
 public:
  DxfReader(std::string_view text, const std::string& name)
      : groups_(text, name), utf8_(is_utf8(text)) {
    const auto is_wide = [](char c) { return static_cast<unsigned char>(c) >= 0xE0; };
    wide_utf8_ = utf8_ && std::any_of(text.begin(), text.end(), is_wide);
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
        // Two bytes of an East Asian page may look like a character of two bytes in UTF-8.
        const bool two_bytes = code_page_ == "CP932" || code_page_ == "CP936" ||
                               code_page_ == "CP949" || code_page_ == "CP950";
        if (two_bytes && !wide_utf8_) utf8_ = false;
      } else if (variable == "$INSUNITS" && group.code == 70) {
        drawing_.unit_metres = unit(groups_.integer(group));
      } else if (variable == "$MEASUREMENT" && group.code == 70) {
        drawing_.measurement =
            groups_.integer(group) == 0 ? DxfMeasurement::english : DxfMeasurement::metric;
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

  void blocks() {
    groups_.next();
    while (!groups_.is(0, "ENDSEC")) {
      if (!groups_.is(0, "BLOCK")) {
        groups_.fail(
            "'" + shown_text(dxf_trimmed(groups_.now().value)) + "' stands where a block begins",
            "the file is damaged; save it again");
      }
      const DxfRecord head = groups_.record();
      DxfBlock block;
      block.line = head.line;
      Vec2 base = Vec2::Zero();
      for (const DxfGroup& group : head.groups) {
        if (group.code == 2) block.name = text(dxf_trimmed(group.value));
        if (group.code == 10) base.x() = groups_.coordinate(group);
        if (group.code == 20) base.y() = groups_.coordinate(group);
      }
      entities(block.entities);
      if (!groups_.is(0, "ENDBLK")) groups_.fail("a block has no end", "save the file again");
      groups_.record();
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
      entity(groups_.record(), list);
    }
  }

  void count_entity(int line) {
    if (++entities_ > max_dxf_entities) {
      groups_.fail_at(line,
                      "the file has more than " + std::to_string(max_dxf_entities) + " entities",
                      "is it really a pattern? keep the layers of the pieces only");
    }
  }

  void count_curves(int line, std::size_t count) {
    curves_ += count;
    if (curves_ > static_cast<std::size_t>(max_dxf_curves)) {
      groups_.fail_at(
          line, "the file has more than " + std::to_string(max_dxf_curves) + " sides of curves",
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
      if (group.code == 67) paper = groups_.integer(group) == 1;
      if (group.code == 230) tilt = groups_.number(group);
    }
    // Entities are drawn in the plane, or in the plane as seen from behind.
    const bool flat = std::abs(std::abs(tilt) - 1) < 1e-6;
    const bool behind = flat && tilt < 0;
    bool known = flat && !paper;
    const std::string_view type = record.type;
    if (type == "POLYLINE") {
      known = polyline(record, entity) && known;
    } else if (type == "LWPOLYLINE") {
      entity.curves = dxf_lightweight_polyline(groups_, record);
    } else if (type == "LINE") {
      entity.curves = {dxf_line(groups_, record)};
    } else if (type == "ARC" || type == "CIRCLE") {
      read_dxf_arc(groups_, record, entity);
    } else if (type == "ELLIPSE") {
      read_dxf_ellipse(groups_, record, behind, entity);
    } else if (type == "SPLINE") {
      const DxfSpline spline = dxf_spline(groups_, record);
      count_curves(record.line, 16 * (spline.control_points.size() + spline.fit_points.size()));
      entity.curves = spline_curves(spline);
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

  /// Reads the vertices behind the head, too. False for meshes in space.
  bool polyline(const DxfRecord& head, DxfEntity& entity) {
    int flags = 0;
    for (const DxfGroup& group : head.groups) {
      if (group.code == 70) flags = groups_.integer(group);
    }
    constexpr int closed = 1;
    constexpr int spline_fitted = 4;
    constexpr int meshes = 16 + 64;
    constexpr int control_point = 16;
    std::vector<DxfVertex> vertices;
    while (groups_.is(0, "VERTEX")) {
      const DxfRecord record = groups_.record();
      count_curves(record.line, 1);
      const DxfVertex vertex = dxf_vertex(groups_, record);
      if ((flags & spline_fitted) != 0 && (vertex.flags & control_point) != 0) continue;
      vertices.push_back(vertex);
    }
    if (groups_.is(0, "SEQEND")) groups_.record();
    if ((flags & meshes) != 0) return false;
    append_dxf_sides(entity.curves, vertices, (flags & closed) != 0);
    return true;
  }

  /// A point or a text.
  void mark(const DxfRecord& record, DxfEntity& entity) const {
    const bool paragraphs = record.type == "MTEXT";
    entity.kind = record.type == "POINT" ? DxfEntity::Kind::point : DxfEntity::Kind::text;
    std::string content;
    for (const DxfGroup& group : record.groups) {
      if (group.code == 10) entity.at.x() = groups_.coordinate(group);
      if (group.code == 20) entity.at.y() = groups_.coordinate(group);
      if (group.code == 50) {
        entity.angle = std::remainder(groups_.number(group), 360) * radians_per_degree;
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
      follow = follow || (group.code == 66 && groups_.integer(group) == 1);
    if (!follow) return;
    while (groups_.is(0, "ATTRIB")) entity(groups_.record(), list);
    if (groups_.is(0, "SEQEND")) groups_.record();
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
      if (group.code == 10) entity.at.x() = groups_.coordinate(group);
      if (group.code == 20) entity.at.y() = groups_.coordinate(group);
      if (group.code == 41) scale.x() = groups_.coordinate(group);
      if (group.code == 42) scale.y() = groups_.coordinate(group);
      if (group.code == 44) step.x() = groups_.coordinate(group);
      if (group.code == 45) step.y() = groups_.coordinate(group);
      if (group.code == 50) {
        entity.angle = std::remainder(groups_.number(group), 360) * radians_per_degree;
      }
      if (group.code == 70) columns = std::max(1, groups_.integer(group));
      if (group.code == 71) rows = std::max(1, groups_.integer(group));
    }
    if (scale.x() == 0 || scale.y() == 0) groups_.fail_at(record.line, "an insert has the scale 0");
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
  DxfDrawing drawing_;
  std::vector<Vec2> bases_;  ///< of blocks: the points that inserts place
  std::string code_page_ = "CP1252";
  bool utf8_ = false;
  bool wide_utf8_ = false;  ///< with characters of three bytes or more, as East Asian ones are
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
