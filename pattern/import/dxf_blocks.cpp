#include "pattern/import/dxf_blocks.h"

#include <algorithm>

#include "geometry/error.h"
#include "io/json_words.h"
#include "pattern/import/dxf_layers.h"

namespace toile {

namespace {

/// Inserts within inserts.
constexpr int max_insert_depth = 16;

/// Units of the drawing: beyond, products of coordinates lose their digits.
constexpr double max_placed = 1e9;

/// Finds the pieces among blocks and inserts.
class BlockPieces {
 public:
  BlockPieces(const DxfDrawing& drawing, bool layered, const std::string& source,
              std::vector<Remark>& remarks)
      : drawing_(drawing), layered_(layered), source_(source), remarks_(remarks) {
    carried_.assign(drawing.blocks.size(), unknown);
    for (std::size_t i = 0; i < drawing.blocks.size(); ++i) carried(static_cast<int>(i), 0);
    uses_.resize(drawing.blocks.size());
  }

  std::vector<DrawnPiece> pieces() {
    visit_inserts(drawing_.entities, Eigen::Affine2d::Identity(), 0);
    for (std::size_t i = 0; i < uses_.size(); ++i) {
      const std::string& name = drawing_.blocks[i].name;
      // Without layers, arrow heads and dimensions look like pieces.
      const bool helper = !layered_ && !name.empty() && (name[0] == '*' || name[0] == '_');
      if (!uses_[i].used && !uses_[i].part && !helper && is_piece(static_cast<int>(i))) {
        visit(static_cast<int>(i), Eigen::Affine2d::Identity(), 0);
      }
    }
    std::vector<DrawnPiece> pieces;
    for (std::size_t i = 0; i < uses_.size(); ++i) {
      if (!uses_[i].used || !is_piece(static_cast<int>(i))) continue;
      DrawnPiece drawn;
      drawn.name = drawing_.blocks[i].name;
      drawn.mirrored_twin = uses_[i].mirrored_twin;
      gather(static_cast<int>(i), uses_[i].placed, 0, drawn);
      if (uses_[i].more > 0 && !uses_[i].mirrored_twin) {
        remarks_.push_back({false, source_ + ": block " + in_quotes(drawn.name) + " is inserted " +
                                       std::to_string(uses_[i].more + 1) +
                                       " times; it is one piece"});
      }
      pieces.push_back(std::move(drawn));
    }
    return pieces;
  }

 private:
  static constexpr int unknown = -1;
  static constexpr int several = 2;

  /// How a block is used.
  struct Use {
    bool used = false;
    bool part = false;  ///< of another piece
    int more = 0;       ///< inserts after the first
    bool mirrored_twin = false;
    Eigen::Affine2d placed = Eigen::Affine2d::Identity();
  };

  const DxfBlock& block(int index) const {
    return drawing_.blocks[static_cast<std::size_t>(index)];
  }

  [[noreturn]] void too_deep(int index) const {
    throw Error(source_ + ":" + std::to_string(block(index).line),
                "block " + in_quotes(block(index).name) +
                    " inserts itself, or blocks are nested deeper than " +
                    std::to_string(max_insert_depth),
                "explode the inserts in the CAD program");
  }

  [[noreturn]] void too_far(int index) const {
    throw Error(source_ + ":" + std::to_string(block(index).line),
                "block " + in_quotes(block(index).name) + " is inserted too far away or too large",
                "correct the insert in the CAD program");
  }

  /// Outlines in a block: 0, 1 or several. An outline of its own hides those of its inserts.
  int carried(int index, int depth) {
    int& known = carried_[static_cast<std::size_t>(index)];
    if (known != unknown) return known;
    if (depth > max_insert_depth) too_deep(index);
    int count = 0;
    bool own = false;
    for (const DxfEntity& entity : block(index).entities) {
      own = own || is_outline(entity, layered_);
      if (entity.kind == DxfEntity::Kind::insert) count += carried(entity.block, depth + 1);
      count = std::min(count, several);
    }
    return carried_[static_cast<std::size_t>(index)] = own ? 1 : count;
  }

  bool is_piece(int index) const { return carried_[static_cast<std::size_t>(index)] == 1; }

  bool own_outline(int index) const {
    const auto& entities = block(index).entities;
    return std::any_of(entities.begin(), entities.end(),
                       [&](const DxfEntity& entity) { return is_outline(entity, layered_); });
  }

  void visit_inserts(const std::vector<DxfEntity>& list, const Eigen::Affine2d& placed, int depth) {
    for (const DxfEntity& entity : list) {
      if (entity.kind != DxfEntity::Kind::insert) continue;
      if (carried_[static_cast<std::size_t>(entity.block)] == 0) continue;
      visit(entity.block, placed * entity.placed, depth + 1);
    }
  }

  void visit(int index, const Eigen::Affine2d& placed, int depth) {
    if (depth > max_insert_depth) too_deep(index);
    if (++visits_ > max_piece_entities) {
      throw Error(source_, "has more than " + std::to_string(max_piece_entities) + " inserts",
                  "is it really a pattern? keep the layers of the pieces only");
    }
    if (!placed.matrix().allFinite()) too_far(index);
    if (!is_piece(index)) {
      visit_inserts(block(index).entities, placed, depth);
      return;
    }
    Use& use = uses_[static_cast<std::size_t>(index)];
    if (use.used) {
      ++use.more;
      const bool turned =
          (use.placed.linear().determinant() < 0) != (placed.linear().determinant() < 0);
      use.mirrored_twin = use.mirrored_twin || turned;
      return;
    }
    use.used = true;
    use.placed = placed;
    if (own_outline(index))
      visit_inserts(block(index).entities, placed, depth);
    else
      mark_parts(index);
  }

  /// What a block without an outline of its own inserts is part of it.
  void mark_parts(int index) {
    for (const DxfEntity& entity : block(index).entities) {
      if (entity.kind != DxfEntity::Kind::insert) continue;
      Use& use = uses_[static_cast<std::size_t>(entity.block)];
      if (use.part || carried_[static_cast<std::size_t>(entity.block)] == 0) continue;
      use.part = true;
      mark_parts(entity.block);
    }
  }

  void gather(int index, const Eigen::Affine2d& placed, int depth, DrawnPiece& drawn) {
    if (depth > max_insert_depth) too_deep(index);
    const bool own = own_outline(index);
    for (const DxfEntity& entity : block(index).entities) {
      if (entity.kind == DxfEntity::Kind::insert) {
        // An inserted outline is a piece of its own, beside one of this block.
        const bool apart = own && carried_[static_cast<std::size_t>(entity.block)] > 0;
        if (!apart) gather(entity.block, placed * entity.placed, depth + 1, drawn);
        continue;
      }
      gathered_ += std::max<std::size_t>(1, entity.curves.size());
      if (gathered_ > max_piece_entities) {
        throw Error(source_,
                    "its pieces have more than " + std::to_string(max_piece_entities) +
                        " entities or lines, inserts included",
                    "is it really a pattern? keep the layers of the pieces only");
      }
      drawn.entities.push_back(transformed(entity, placed));
      for (const DxfCurve& curve : drawn.entities.back().curves) {
        for (const Vec2& point : curve.points) {
          if (!(point.cwiseAbs().maxCoeff() < max_placed)) too_far(index);
        }
      }
      if (!(drawn.entities.back().at.cwiseAbs().maxCoeff() < max_placed)) too_far(index);
    }
  }

  const DxfDrawing& drawing_;
  bool layered_;
  const std::string& source_;
  std::vector<Remark>& remarks_;
  std::vector<int> carried_;
  std::vector<Use> uses_;
  std::size_t gathered_ = 0;
  std::size_t visits_ = 0;
};

}  // namespace

std::vector<DrawnPiece> pieces_in_blocks(const DxfDrawing& drawing, bool layered,
                                         const std::string& source, std::vector<Remark>& remarks) {
  return BlockPieces(drawing, layered, source, remarks).pieces();
}

}  // namespace toile
