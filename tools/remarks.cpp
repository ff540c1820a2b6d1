#include "tools/remarks.h"

#include <nlohmann/json.hpp>

#include "io/text.h"
#include "tools/report.h"

namespace toile {

void say_remarks(const std::vector<Remark>& remarks, const CommonSettings& common) {
  for (const Remark& remark : remarks) {
    if (remark.warning) {
      CommonSettings::warn(remark.text);
    } else {
      common.say("note: " + remark.text);
    }
  }
}

std::vector<std::string> warnings_in(const std::vector<Remark>& remarks) {
  std::vector<std::string> warnings;
  for (const Remark& remark : remarks) {
    if (remark.warning) warnings.push_back(remark.text);
  }
  return warnings;
}

void add_remarks(const std::vector<Remark>& remarks, nlohmann::ordered_json& report) {
  report["notes"] = nlohmann::ordered_json::array();
  report["warnings"] = warnings_json(warnings_of("pattern", warnings_in(remarks)));
  for (const Remark& remark : remarks) {
    if (!remark.warning) report["notes"].push_back(valid_utf8(remark.text));
  }
}

}  // namespace toile
