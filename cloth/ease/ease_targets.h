// How much ease a garment is meant to have.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cloth/ease/garment_levels.h"
#include "cloth/ease/girths.h"

namespace toile {

/// The ease as cut that a level is meant to have, metres.
struct EaseTarget {
  std::string level;  ///< a Girth's or a GarmentLevel's name; of what has sides, without its side
  double least = 0;
  double most = 0;
};

struct EaseTargets {
  std::string name;
  std::vector<EaseTarget> levels;
};

/// Names of the tables that are built in: `close`, `fitted`, `semi-fitted`, `loose`, for woven
/// fabrics. Bust and hip are of the ease chart of Butterick, McCall's and Vogue patterns, in
/// inches. What hangs from the waist gets up to an inch at its top edge [Palmer & Alto, Fit for
/// Real People].
std::vector<std::string> ease_target_names();

/// The table of that name, or that of a JSON file:
/// {"name": "our blouse", "ease_cm": {"bust": [7, 10], "upper arm": [4, 7]}}. Throws Error for a
/// name that is neither, and for a file that is damaged or has a range from more to less.
EaseTargets read_ease_targets(const std::string& name_or_file);

/// The target of a level, with or without its side; null: it has none.
const EaseTarget* target_of(const EaseTargets& targets, const std::string& level);

/// A level against its target. Metres.
struct TargetFinding {
  std::string level;  ///< with its side
  double ease = 0;    ///< as cut; of an edge beside GarmentLevel::compared()
  double error = 0;
  EaseTarget target;
  std::vector<int> panels = {};  ///< of the garment, that meet there

  /// By how much the ease is beyond the target; negative: short of it; 0: as intended.
  double off() const;
  /// "too tight", "close", "as intended", "loose" or "too wide". Tight and wide are off by more
  /// than the error.
  std::string word() const;
};

/// Whether one level is too wide and none too tight.
bool is_too_wide(const std::vector<TargetFinding>& findings);

/// The levels that have a target, in the order of the garment's.
std::vector<TargetFinding> compare_with_targets(const EaseTargets& targets,
                                                const std::vector<Girth>& girths,
                                                const std::vector<GarmentLevel>& levels);

/// "too wide by 2.1 ± 1.1 cm at the top edge: ease 4.6 cm, meant 0.0 to 2.5 cm"
std::string text_of(const TargetFinding& finding);

}  // namespace toile
