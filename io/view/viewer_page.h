// A web page in one file: a surface coloured by quantities, turned by the mouse. Its flat pieces
// lie beside it, and rows of tables light up on both.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/types.h"
#include "io/view/colour.h"

namespace toile {

/// A column of a table. Lengths are in centimetres; the page can show them in inches.
struct PageColumn {
  PageColumn(std::string text) : name(std::move(text)) {}  // NOLINT: a plain text is a column
  PageColumn(const char* text) : name(text) {}             // NOLINT
  PageColumn(std::string text, bool of_lengths) : name(std::move(text)), is_length(of_lengths) {}
  std::string name;
  bool is_length = false;
};

/// A table of the page. Cells are text. The first column is aligned left, the others right.
struct PageTable {
  std::string caption;
  std::vector<PageColumn> columns;
  std::vector<std::vector<std::string>> rows;  ///< each as long as `columns`
  std::vector<int> regions;     ///< empty, or one a row: index of the region it is about; -1: none
  std::string remark;           ///< under the table, lines of their own; empty: none
  std::vector<int> lines = {};  ///< empty, or one a row: index into ViewerPage::lines; -1: none
  std::vector<bool> between = {};  ///< empty, or one a row: the print leaves it out
  std::vector<bool> hurts = {};    ///< empty, or one a row: it is marked
  std::vector<bool> quiet = {};    ///< empty, or one a row: it is grey
  int sheet = 0;                   ///< of the print, 1 or 2; 0: it is on the screen only
};

/// A quantity of each point.
struct PageMap {
  std::string tab;             ///< maps of one tab are one group; empty: no map, read only
  std::string name;            ///< within its tab; empty: it is alone there
  std::string reading;         ///< what the pointer's box calls it, "gap"; empty: not in the box
  std::string unit;            ///< such as "mm"; empty: none
  int decimals = 1;            ///< in the pointer's box
  std::vector<double> values;  ///< one a point
  ColourBar bar;               ///< not used without a tab
  std::string meaning;         ///< a sentence or two; empty: none
};

/// Another surface that is drawn in one colour, such as the body.
struct PageSetting {
  std::string name;
  TriangleMesh mesh;  ///< metres, y up
};

/// A place on the surface: between two of its points.
struct PagePlace {
  int a = 0;        ///< index of a point
  int b = 0;        ///< index of a point
  double part = 0;  ///< 0 at `a`, 1 at `b`
};

/// A line that a row of a table lights up.
struct PageLine {
  std::vector<std::array<PagePlace, 2>> pieces;  ///< straight, on the surface
  /// The first setting is cut by this plane, near the line. A normal of zero: it is not.
  Vec3 origin = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
};

/// A line of what hurts.
struct PageReason {
  std::string text;
  int line = -1;  ///< that it lights up: index into ViewerPage::lines; -1: none
};

/// What the page says first.
struct PageVerdict {
  enum class Tone { good, fair, bad };
  std::string word;  ///< such as "sewn"; empty: there is none
  Tone tone = Tone::bad;
  std::vector<PageReason> reasons;  ///< the worst first; the page opens with its line lit
};

/// The content of the page. Text may hold any bytes; it is escaped.
struct ViewerPage {
  std::string title;
  std::vector<std::array<std::string, 2>> facts;  ///< name and value, under the title
  PageVerdict verdict;
  std::vector<std::string> warnings;    ///< below the verdict
  std::vector<std::string> paragraphs;  ///< below that

  std::vector<Vec3> nodes;           ///< metres, y up
  std::vector<int> node_of;          ///< per point, its node; empty: each node is a point
  std::vector<Vec2> flat;            ///< metres, per point, pieces side by side; empty: no pieces
  std::vector<Vec2> pattern;         ///< metres, per point, in the piece's own coordinates
  std::vector<Triangle> triangles;   ///< of points
  std::vector<std::string> regions;  ///< names of the regions
  std::vector<int> region_of_triangle;  ///< one a triangle, index into `regions`
  std::vector<PageMap> maps;            ///< at least one; the first is shown

  std::vector<PageSetting> settings;  ///< each can be hidden
  std::vector<PageTable> tables;
  std::vector<PageLine> lines;
  std::string still_png;  ///< bytes of a picture of the first map, for print and for browsers
                          ///< without WebGL; empty: none
};

/// The page as HTML. It contains all it needs, three.js r111 and its orbit controls included. It
/// loads nothing from the network, which its content security policy forbids. It speaks English,
/// German and French: io/view/viewer/words. Some 5
/// bytes a point and map, and 75 a point besides.
std::string viewer_page(const ViewerPage& page);

}  // namespace toile
