// What import-pattern does once it knows what is asked.
#pragma once

#include <boost/program_options.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "pattern/import/dxf_pieces.h"
#include "pattern/import/imported_pattern.h"
#include "tools/program.h"

namespace toile {

struct ImportPatternSettings {
  std::filesystem::path drawing;
  DrawingOptions drawn;
  ImportOptions pieces;
  bool makes_whole = false;  ///< a whole garment of a drawing of half of one, see whole_garment()
  std::vector<std::string> of_drawings;  ///< options that were given and mean nothing to a JSON
};

/// Its options, but for the drawing.
void add_import_options(boost::program_options::options_description& options);
/// Reads them. Throws UsageError for a value that an option can't take.
void read_import_options(const boost::program_options::variables_map& given,
                         ImportPatternSettings& settings);

/// What became of a drawing.
struct ImportEnd {
  PieceDrawing drawing;          ///< without pieces: it was a JSON, which is a pattern already
  ImportedPattern pattern;       ///< without panels: the same
  bool is_half_garment = false;  ///< all that is unfolded was drawn without a mark
};

/// A pattern, and where it came from.
struct ImportedFile {
  std::string text;    ///< of its file
  std::string format;  ///< of the drawing: "dxf", "svg" or "json"
  std::size_t panels = 0;
  std::vector<Remark> remarks;
  ImportEnd end;
};

/// Makes a pattern of a drawing's `text`; `name` stands for its file in messages, and `output` for
/// the pattern's. As run_import_pattern() otherwise.
ImportedFile import_drawing(const std::string& text, const std::string& name,
                            const std::string& output, const ImportPatternSettings& settings);

/// Reads the drawing and writes the pattern. A GarmentCode JSON is checked and written as
/// it is, or repaired, see repaired_pattern().
/// Pieces that can't be panels are left out. Throws Error for what can't be read or made a
/// pattern.
ImportEnd run_import_pattern(const ImportPatternSettings& settings, const CommonSettings& common);

/// Writes the pattern of each size of the drawing into the folder `common.output`, as SIZE.json. It
/// names the panels whose edges are not as many as in the base size. Returns whether no piece of
/// any size was left out.
///
/// Throws Error for a JSON and a drawing without sizes, and as above, with no pattern written.
bool import_all_sizes(const ImportPatternSettings& settings, const CommonSettings& common);

}  // namespace toile
