// A web page of one file that shows a surface coloured by a quantity, to be turned with the mouse.
#pragma once

#include <string>
#include <vector>

#include "geometry/types.h"
#include "io/view/colour.h"

namespace toile {

/// A table of the page. Cells are text; the first column is set left, the others right.
struct PageTable {
  std::string caption;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  ///< each as long as `columns`
  std::vector<int> regions;  ///< one a row, or empty: the region that the row is about, -1: none
  std::string remark;        ///< under the table; empty: none
};

/// What the page shows. All text may hold any bytes: it is escaped.
struct ViewerPage {
  std::string title;
  std::vector<std::string> paragraphs;  ///< under the title

  TriangleMesh surface;                 ///< metres, y up
  std::vector<double> values;           ///< one a point of `surface`
  std::vector<std::string> regions;     ///< names
  std::vector<int> region_of_triangle;  ///< one a triangle of `surface`, index into `regions`
  std::string quantity;                 ///< such as "Gap"
  std::string unit;                     ///< such as "mm"
  ColourRamp ramp;
  std::string below;  ///< what the colour below the ramp means

  TriangleMesh setting;      ///< drawn in one colour, can be hidden; such as the body
  std::string setting_name;  ///< such as "body"

  std::vector<PageTable> tables;
  std::string still_png;  ///< bytes of a picture to show where there is no WebGL; empty: none
};

/// The page as HTML. It holds all it needs (three.js r111 and its orbit controls are in it) and
/// asks for nothing from the network; its content security policy forbids it to.
std::string viewer_page(const ViewerPage& page);

}  // namespace toile
