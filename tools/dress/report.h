// What dress says of a dressed garment: the report's entry, the lines for the user.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "cloth/dressing/dress.h"
#include "cloth/dressing/quality.h"
#include "cloth/judge/certify.h"
#include "cloth/judge/verdict.h"
#include "tools/program.h"

namespace toile {

/// Every figure of the report of one garment. `seconds` is what it took as a whole.
nlohmann::ordered_json report_of(const PanelMesh& garment, const Scene& scene,
                                 const std::string& method, const DressResult& result,
                                 const Judgement& judgement, double seconds);

/// The preset that a garment was draped by, and the error to expect of it: two entries of a report.
nlohmann::ordered_json quality_json(const Quality& quality);

/// A residual in node weights, and ways in millimetres, as entries of a report.
nlohmann::ordered_json residual_json(const Residual& residual);
nlohmann::ordered_json moved_json(const MovedFigures& moved);

/// What each stage took, and where it came to.
nlohmann::ordered_json stages_json(const std::vector<StageReport>& stages);

/// What --certify-frames found: its entry in the report, and a line for the user or a warning.
nlohmann::ordered_json certified_json(const Certificate& certificate);
void say_certificate(const Certificate& certificate, const CommonSettings& common);

/// Where the skeleton positioned the panels, for those that asked for it.
void say_positions(const Placement& placement, const CommonSettings& common);

/// What was compiled, by term, with counts.
void say_terms(const DressResult& result, const CommonSettings& common);

/// Seams, intersections, strain, wraps and the verdict; warns of what looks wrong.
void say_result(const DressResult& result, const Judgement& judgement,
                const CommonSettings& common);

}  // namespace toile
