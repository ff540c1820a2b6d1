// What the texts of a piece say about it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace toile {

/// How often a piece is cut.
struct PieceQuantity {
  int count = 1;
  bool pair = false;           ///< half of them mirrored
  bool none_mirrored = false;  ///< it is said that none is
};

/// A number of pieces in words: "2"; "1,1" and "1+1", as drawn and mirrored; "1 pair"; "2
/// mirrored"; "left and right". Nothing without such a word or a number beyond 0.
std::optional<PieceQuantity> read_quantity(const std::string& text);

/// The texts of a piece or of a whole drawing, as ASTM D6673 writes them: "Piece Name: FRONT".
class PieceTexts {
 public:
  /// Takes a text, line by line.
  void add(const std::string& text);

  /// The value of a key, such as "piece name" in small letters; empty: not stated. The first
  /// counts.
  std::string value(const std::string& key) const;

  /// How often the piece is cut: by the key "quantity", by a line "Fabric, Cut 2", or by an
  /// annotation "2X FABRIC". A quantity of 0 is none that a maker stated.
  std::optional<PieceQuantity> quantity() const;
  /// The fabric: by the key "material", or by a line "Fabric, Cut 2".
  std::string material() const;

  /// A line without a key that is `name` but for capitals and blanks; empty: there is none. Blocks
  /// of old files are named in capitals.
  std::string spelling_of(const std::string& name) const;

  /// Lines whose key is not known, and lines without a key.
  int others() const { return others_; }

 private:
  std::map<std::string, std::string> values_;
  std::vector<std::string> plain_;
  std::string cut_material_;
  std::optional<PieceQuantity> cut_quantity_;
  int others_ = 0;
};

}  // namespace toile
