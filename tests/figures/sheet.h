// A figure on its way to the page: files in a folder, and one JSON that says what they are.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/figures/paper_dressing.h"

namespace toile::figures {

struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points;
  bool dashed = false;
};

struct Chart {
  std::string title;
  std::string x;  ///< axes' names, with units
  std::string y;
  std::vector<Curve> curves;
};

/// One of the page's sections. Text is plain; the page escapes it.
class Sheet {
 public:
  /// `name` such as "fig10"; files are FOLDER/name….
  Sheet(std::filesystem::path folder, std::string name, const std::string& title);
  ~Sheet();

  void say(const std::string& paragraph);
  /// A row of pictures under one heading; each PNG bytes and a caption.
  void pictures(const std::string& heading,
                const std::vector<std::pair<std::string, std::string>>& png_and_caption);
  void chart(const Chart& chart);  ///< also written as name_TITLE.csv
  void table(const std::string& caption, const std::vector<std::string>& columns,
             const std::vector<std::vector<std::string>>& rows);
  /// A line of the page's table *paper's number · ours*. `holds` empty: nothing to be judged.
  void compare(const std::string& what, const std::string& paper, const std::string& ours,
               std::optional<bool> holds = {});
  /// A line of the page's table of garments; dressed.obj and the curve of its way are written too.
  /// `wanted` is the verdict that the figure asks for.
  void garment(const PaperDressing& dressing, const std::string& wanted = "sewn");
  void file(const std::string& suffix, const std::string& bytes);
  /// Writes name.json: the sheet counts from here on.
  void write();

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// What every figure program is given.
struct SheetSettings {
  std::filesystem::path folder;
  double edge_length = 0.015;  ///< metres
};

/// Runs a figure program: FOLDER [EDGE_MM] on the command line. Returns its exit code.
int run_sheet(int argc, char** argv, void (*work)(const SheetSettings&));

std::string number(double value, int decimals);

}  // namespace toile::figures
