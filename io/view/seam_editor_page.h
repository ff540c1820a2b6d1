// A web page in one file on which the seams of a pattern are drawn.
#pragma once

#include <string>

namespace toile {

/// The content of the page. Text may hold any bytes that are JSON where JSON is asked for.
struct SeamEditorPage {
  std::string name;       ///< of the file that the page saves, such as "tshirt.json"
  std::string pattern;    ///< JSON: the pattern, a GarmentCode file
  std::string proposals;  ///< JSON: the report of find-seams; empty: none
  bool served = false;    ///< a server saves, finds seams and dresses, see tools/edit_seams
  std::string version;    ///< of the file that saving replaces; empty: none
  std::string body;       ///< name of the body that the server dresses; empty: none
};

/// The page as HTML. It contains all it needs. It loads nothing from the network: its content
/// security policy lets it talk to its own server at most. three.js is in it where a body is.
std::string seam_editor_page(const SeamEditorPage& page);

}  // namespace toile
