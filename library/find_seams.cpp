#include "toile/find_seams.h"

#include <nlohmann/json.hpp>

#include "library/rooms.h"
#include "tools/find_seams/run.h"
#include "tools/report.h"

namespace toile {
inline namespace library {

SewingPattern find_seams(const SewingPattern& pattern, const FindSeamsChoices& choices) {
  return guarded([&] {
    if (!(choices.min_confidence >= 0 && choices.min_confidence <= 1)) {
      throw Error("min_confidence", "is not between 0 and 1", "0.7 is the default");
    }
    FindSeamsSettings settings;
    settings.keep = choices.keep;
    settings.sewn = choices.sewn;
    settings.with = choices.with;
    settings.without = choices.without;
    settings.min_confidence = choices.min_confidence;
    settings.time_limit = choices.time_limit;
    const CommonSettings common = settings_of("find-seams");
    const SewnPattern sewn = sew_pattern(pattern.json, pattern.name, settings, common);
    return SewingPattern{
        sewn.text, pattern.name,
        report_text(common, find_seams_json(pattern.name, sewn.found, sewn.end.left_out,
                                            settings.min_confidence, sewn.remarks))};
  });
}

}  // namespace library
}  // namespace toile
