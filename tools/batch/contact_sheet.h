// index.html of a batch: the pictures of all garments beside their verdicts.
#pragma once

#include <string>

#include "tools/batch/results.h"

namespace toile {

/// A page that needs no network. Pictures are files in the garments' folders beside it. Buttons
/// show the garments of one verdict only. Garments that are not done yet are counted alone.
std::string contact_sheet(const RowReports& reports);

}  // namespace toile
