// The page on paper.
#pragma once

#include <string>

namespace toile {

/// The bytes of a PDF file of the page, A4, as Chromium prints it. Throws Error where no Chromium
/// or Chrome is on the PATH, and where it fails. Takes seconds.
std::string printed_page(const std::string& html);

/// Throws Error where no Chromium or Chrome is on the PATH.
void check_printer();

}  // namespace toile
