#include "tools/batch/outcome.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cloth/judge/verdict.h"
#include "geometry/error.h"
#include "io/json_value.h"
#include "io/text.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

/// "left side (2.1 cm), right side (1.0 cm), and 3 more".
std::string names_of_seams(const Json& report, const char* key, const char* length) {
  constexpr std::size_t max_named = 4;
  const Json seams = report.value(key, Json::array());
  std::string names;
  for (const Json& seam : seams) {
    if (&seam - &seams.front() == max_named) {
      return names + ", and " + std::to_string(seams.size() - max_named) + " more";
    }
    if (!names.empty()) names += ", ";
    names += seam.at("name").get<std::string>() + " (" +
             fixed_number(seam.at(length).get<double>(), 1) + " cm)";
  }
  return names;
}

/// "left forearm: 16.6 cm around 22.4 cm; "; empty: no part is cut smaller than the body.
std::string girths_too_small(const Json& report) {
  std::string text;
  for (const Json& level : report.at("fit").at("levels")) {
    text += level.at("name").get<std::string>() + ": " +
            fixed_number(level.at("as_cut_cm").get<double>(), 1) + " cm around " +
            fixed_number(level.at("body_cm").get<double>(), 1) + " cm; ";
  }
  return text;
}

/// "the body", "itself" or both; empty: nothing.
std::string crossed(const Json& intersections) {
  const bool body = intersections.at("body").get<int>() > 0;
  const bool self = intersections.at("self").get<int>() > 0;
  if (body && self) return "the body and itself";
  return body ? "the body" : self ? "itself" : "";
}

std::string joined(const Json& texts) {
  std::string line;
  for (const Json& text : texts) line += (line.empty() ? "" : ", ") + text.get<std::string>();
  return line;
}

/// Cause and detail of a verdict.
std::pair<std::string, std::string> reason_of(const Json& report, const std::string& verdict) {
  const Json& intersections = report.at("intersections");
  const std::string crosses = crossed(intersections);
  if (verdict == "unsewable") {
    return {"a seam stays open" + (crosses.empty() ? "" : ", and the cloth crosses " + crosses),
            names_of_seams(report, "unsewable_seams", "gap_cm")};
  }
  if (verdict == "intersecting") {
    return {"the cloth crosses " + crosses,
            "pairs of triangles: " + std::to_string(intersections.at("body").get<int>()) +
                " with the body, " + std::to_string(intersections.at("self").get<int>()) +
                " with itself"};
  }
  if (verdict == "misplaced") {
    const Json& misplaced = report.at("misplaced");
    return {"not worn as it should be: " + misplaced.at("part").get<std::string>(),
            "wanted: " + misplaced.at("should_be").get<std::string>() +
                "; found: " + misplaced.at("at").get<std::string>()};
  }
  if (verdict == "unwrapped") {
    const std::string parts = joined(report.at("unwrapped"));
    return {"does not go around " + parts, parts};
  }
  if (verdict == "unconverged") {
    return {"did not come to rest",
            "residual: median " + number_text(report.at("residual").at("median").get<double>(), 2) +
                ", wide " + number_text(report.at("residual").at("wide").get<double>(), 2)};
  }
  if (verdict == "too_tight") {
    return {report.contains("tight_seams") ? "a seam pulls more than a hand"
                                           : "cloth is stretched by more than a quarter",
            girths_too_small(report) + names_of_seams(report, "tight_seams", "missing_cm")};
  }
  return {verdict == "sewn" ? "" : verdict, ""};
}

Json figures_of(const Json& report) {
  int attempts = 0;
  for (const Json& stage : report.at("stages")) {
    attempts = std::max(attempts, stage.at("attempt").get<int>());
  }
  const Json& strain = report.at("strain_off_seams");
  return {{"fit", report.at("fit").at("verdict")},
          {"strain_p99", strain.at("p99")},
          {"strain_max", strain.at("max")},
          {"seams_open", report.at("seams").at("open")},
          {"max_gap_mm", report.at("seams").at("max_gap_mm")},
          {"intersections_body", report.at("intersections").at("body")},
          {"intersections_self", report.at("intersections").at("self")},
          {"converged", report.at("converged")},
          {"attempts", attempts},
          {"nodes", report.at("garment").at("nodes")}};
}

/// A message without names and numbers, so that those of one kind are the same: "PLACE: PROBLEM;
/// REMEDY" is PROBLEM.
std::string kind_of(const std::string& message) {
  std::string text = message.substr(0, message.find("; "));
  if (const std::size_t place = text.find(": "); place != std::string::npos) {
    text.erase(0, place + 2);
  }
  std::string kind;
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const auto is_letter = [&](std::size_t at) {
      return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
    };
    // An apostrophe within a word quotes nothing.
    if (c == '\'' && !(i > 0 && is_letter(i - 1) && is_letter(i + 1))) {
      if (!is_quoted) kind += "'…'";
      is_quoted = !is_quoted;
    } else if (is_quoted) {
      continue;
    } else if (c >= '0' && c <= '9') {
      if (!kind.ends_with("N") && !kind.ends_with("N.")) kind += 'N';
    } else {
      kind += c;
    }
  }
  return kind;
}

}  // namespace

std::vector<std::string> verdicts_in_order() {
  std::vector<std::string> names;
  for (int i = static_cast<int>(Verdict::sewn); i >= 0; --i) {
    names.push_back(to_string(static_cast<Verdict>(i)));
  }
  names.emplace_back(error_verdict);
  return names;
}

Json outcome_of(const std::string& dress_report, const std::string& file) {
  try {
    const Json report = parse_json(dress_report, file);
    const auto verdict = report.at("verdict").get<std::string>();
    const auto [cause, detail] = reason_of(report, verdict);
    return {{"verdict", verdict},
            {"cause", cause},
            {"detail", detail},
            {"figures", figures_of(report)},
            {"warnings", report.at("warnings")}};
  } catch (const Json::exception&) {
    throw Error(file, "is no report of dress", "let dress write it");
  }
}

Json failure(const std::string& program, const std::string& message) {
  return {{"verdict", error_verdict},
          {"cause", program + ": " + kind_of(message)},
          {"detail", message},
          {"figures", Json::object()},
          {"warnings", Json::array()}};
}

void add_girth_ease(const std::string& ease_report, const std::string& file, Json& figures) {
  try {
    const Json report = parse_json(ease_report, file);
    for (const char* level : {"bust", "waist", "hip"}) {
      Json& ease = figures[std::string(level) + "_ease_cm"];
      for (const Json& girth : report.value("girths", Json::array())) {
        if (girth.value("level", "") != level) continue;
        if (girth.contains("as_cut_ease_cm")) ease = girth.at("as_cut_ease_cm");  // else: a fold
      }
    }
  } catch (const Json::exception&) {
    throw Error(file, "is no report of ease-map", "let ease-map write it");
  }
}

}  // namespace toile
