// Dresses a body with a garment, and judges drapes.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "toile/error.h"
#include "toile/values.h"

namespace toile {
inline namespace library {

struct DressChoices {
  std::string fabric = "default";  ///< a name that `dress --help` lists, or a JSON file
  /// Fabrics of panels, by the names that the pattern gives them.
  std::map<std::string, std::string> fabrics = {};
  std::string quality = "standard";   ///< draft, standard or fine: how far it comes to rest
  bool has_floor = true;              ///< cloth that hangs lower lies on the floor
  std::optional<Drape> earlier = {};  ///< to go on from, of a pattern that was changed a little
};

/// Sews the garment around the body and lets it come to rest. The report has the verdict, fit and
/// warnings: docs/report.md. A body without joints is dressed with a warning.
///
/// The same as dress, and the same bits for any number of threads. Calls on several threads do not
/// disturb each other. Each uses all processors that are free; memory is some 100 MB a call. Throws
/// Error for fabrics that are not known and for garments and bodies that can't be dressed. A
/// garment that can't be sewn is no Error: the verdict says so.
TOILE_API Drape dress(const Garment& garment, const Body& body, const DressChoices& choices = {});

/// Judges a drape as it is, whoever made it: JSON with `verdict`, `fit`, `seams`, `wraps`,
/// `intersections` and what else docs/report.md has between them. What the drape alone does not
/// show is taken from its report: whether it came to rest, and tight seams. Without a report it
/// counts as at rest, and without `started` as started where the pattern puts its panels. Throws
/// Error where drape and garment have other faces. Seconds at 10 mm.
TOILE_API std::string judge(const Drape& drape, const Body& body);

}  // namespace library
}  // namespace toile
