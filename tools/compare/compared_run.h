// A garment that was dressed, or should have been, as `toile compare` reads it from its reports.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cloth/ease/ease_targets.h"

namespace toile {

/// The ease as cut at a girth or an edge. Metres.
struct LevelEase {
  std::string level;
  double ease = 0;
  double error = 0;
  bool tells_size =
      true;  ///< false: of both legs, or a neckline, which `fit` does not count either
};

/// What a run came to.
struct ComparedRun {
  std::filesystem::path report;  ///< the folder or the file that was read
  std::filesystem::path page;    ///< ease.html or the like; empty: there is none
  std::string garment;           ///< name of the pattern or drawing
  std::string size;              ///< empty: nothing states one
  std::string body;
  std::string fabric;  ///< empty: not known
  /// That of dress, or "error": it ended before it was dressed. Empty: no report tells.
  std::string verdict;
  std::string fit;  ///< as in the report; empty: not known
  /// What speaks against it besides fit, in words; empty: it ended with exit code 0.
  std::string why;
  std::vector<LevelEase> levels;
  std::string target;                  ///< name of the ease meant; empty: none
  std::vector<TargetFinding> targets;  ///< levels against it

  /// The level with the least ease that tells the size; null: none was measured.
  const LevelEase* tightest() const;
  /// The level that is farthest off its target; null: none has one.
  const TargetFinding* farthest_off() const;
};

/// Puts another target, or the first, in the place of the run's own.
void set_target(const EaseTargets& targets, ComparedRun& run);

/// Reads the folder of a `toile fit` or `toile try`, also one that ended early. Of a `toile batch`
/// it reads each line of the table; a file is a report of dress or ease-map. Throws Error for what
/// is none of these, and for files that are damaged.
std::vector<ComparedRun> read_runs(const std::filesystem::path& folder_or_file);

}  // namespace toile
