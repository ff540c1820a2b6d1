#include "tools/dress/attachments.h"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

namespace toile {

namespace {

/// Metres, on average: what stands farther off was not held.
constexpr double not_held = 0.02;

}  // namespace

nlohmann::ordered_json attachments_json(const std::vector<AttachmentFigures>& attachments) {
  auto all = nlohmann::ordered_json::array();
  for (const AttachmentFigures& figures : attachments) {
    nlohmann::ordered_json json = {
        {"name", figures.name},
        {"to", figures.to},
        {"while", figures.always ? "always" : "dressing"},
        {"off_mm", {{"mean", 1000 * figures.off_mean}, {"max", 1000 * figures.off_max}}}};
    if (figures.always) {
      json["force_N"] = figures.pull.norm();
      json["pull_N"] = {figures.pull.x(), figures.pull.y(), figures.pull.z()};
    }
    all.push_back(std::move(json));
  }
  return all;
}

void say_attachments(const std::vector<AttachmentFigures>& attachments,
                     const CommonSettings& common) {
  for (const AttachmentFigures& figures : attachments) {
    std::ostringstream line;
    line << std::fixed << std::setprecision(1) << figures.name << " attached to " << figures.to
         << ": " << 1000 * figures.off_mean
         << (figures.always ? " mm off, carries " : " mm off when it was let go");
    if (figures.always) line << figures.pull.norm() << " N";
    common.say(line.str());
    if (figures.off_mean < not_held) continue;
    std::ostringstream warning;
    warning << std::fixed << std::setprecision(1) << "attachment " << figures.name << " stands "
            << 100 * figures.off_mean << " cm off its " << figures.to
            << ": the cloth does not reach, or needs more than its 'max_N'";
    CommonSettings::warn(warning.str());
  }
}

}  // namespace toile
