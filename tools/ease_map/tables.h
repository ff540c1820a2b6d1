// The tables of the page: girths, edges, lengths, targets, gaps of panels, points of measure.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/view/viewer_page.h"
#include "tools/ease_map/findings.h"
#include "tools/ease_map/report.h"

namespace toile {

/// The tables that the report has content for, and the lines that their rows light up.
struct EaseTables {
  std::vector<PageTable> tables;
  std::vector<PageLine> lines;
  std::map<std::string, int> line_of;  ///< of girths and edges, by their names
};
/// `findings` are findings_of() the report: their rows are marked.
EaseTables ease_tables(const EaseReport& report, const std::vector<Finding>& findings);

/// "2.0 short of the left wrist, 3.1 beyond the left elbow"; empty: it ends at nothing.
std::string ends_text(const GarmentLength& length);

}  // namespace toile
