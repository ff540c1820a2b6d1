// A web page in one file that shows a surface coloured by a quantity. The mouse turns it.
#pragma once

#include <string>
#include <vector>

#include "geometry/types.h"
#include "io/view/colour.h"

namespace toile {

/// A table of the page. Cells are text. The first column is aligned left, the others right.
struct PageTable {
  std::string caption;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  ///< each as long as `columns`
  std::vector<int> regions;  ///< empty, or one a row: index of the region it is about; -1: none
  std::string remark;        ///< under the table; empty: none
};

/// The content of the page. Text may hold any bytes; it is escaped.
struct ViewerPage {
  std::string title;
  std::vector<std::string> paragraphs;  ///< under the title

  TriangleMesh surface;                 ///< metres, y up
  std::vector<double> values;           ///< one a point of `surface`
  std::vector<std::string> regions;     ///< names of the regions
  std::vector<int> region_of_triangle;  ///< one a triangle of `surface`, index into `regions`
  std::string quantity;                 ///< name of the values, such as "Gap"
  std::string unit;                     ///< unit of the values, such as "mm"
  ColourRamp ramp;
  std::string below;  ///< meaning of the colour below the ramp; empty: not shown

  TriangleMesh setting;      ///< drawn in one colour, such as the body; can be hidden
  std::string setting_name;  ///< such as "body"

  std::vector<PageTable> tables;
  std::string still_png;  ///< bytes of a picture for browsers without WebGL; empty: none
};

/// The page as HTML. It contains all it needs, three.js r111 and its orbit controls included. It
/// loads nothing from the network, which its content security policy forbids.
std::string viewer_page(const ViewerPage& page);

}  // namespace toile
