// three.js r111 with its orbit controls, as text for pages.
#pragma once

#include <string>

namespace toile {

/// The elements of a page that hold both scripts, after a comment with their licence.
std::string three_js();

}  // namespace toile
