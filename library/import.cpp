#include "toile/import.h"

#include <nlohmann/json.hpp>

#include "io/output_file.h"
#include "library/rooms.h"
#include "tools/import_pattern/report.h"
#include "tools/import_pattern/run.h"
#include "tools/report.h"

namespace toile {
inline namespace library {

SewingPattern import_pattern(const std::filesystem::path& drawing, const ImportChoices& choices) {
  return guarded([&] {
    if (choices.seam_allowance &&
        !(*choices.seam_allowance > 0 && *choices.seam_allowance <= 0.1)) {
      throw Error("seam_allowance", "is not between 0 and 0.1 m", "10 mm is 0.01");
    }
    ImportPatternSettings settings;
    settings.drawing = drawing;
    settings.drawn.unit = choices.metres_per_unit;
    settings.drawn.cut_line = choices.cut_line;
    settings.pieces.size = choices.size;
    settings.pieces.seam_allowance = choices.seam_allowance;
    settings.pieces.unfold = choices.unfold;
    settings.pieces.names = choices.names;
    settings.pieces.pairs = choices.pairs;
    settings.pieces.singles = choices.singles;
    settings.pieces.without = choices.without;
    const CommonSettings common = settings_of("import-pattern");
    const std::string name = drawing.string();
    const ImportedFile imported = import_drawing(read_file(drawing), name, name, settings);
    return SewingPattern{
        imported.text, name,
        report_text(common, import_pattern_json(name, imported.format, imported.end.drawing,
                                                imported.end.pattern, imported.remarks))};
  });
}

}  // namespace library
}  // namespace toile
