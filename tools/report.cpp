#include "tools/report.h"

#include <nlohmann/json.hpp>

namespace toile {

std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void write_report(OutputFiles& files, const CommonSettings& common,
                  const nlohmann::ordered_json& report) {
  if (!common.report) return;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - common.start;
  nlohmann::ordered_json whole = {
      {"program", common.program}, {"version", toile_version()}, {"seconds", seconds.count()}};
  whole.update(report);
  write_file(files.at(*common.report), json_text(whole));
}

}  // namespace toile
