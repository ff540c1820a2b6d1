// The tables of tests/validation/references, by the names of their columns.
#pragma once

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace toile::test {

class ReferenceTable {
 public:
  /// Throws when there is no such file, or a row is short of columns.
  explicit ReferenceTable(const std::string& name) {
    std::ifstream file(std::string(TOILE_SOURCE_DIR) + "/tests/validation/references/" + name);
    if (!file) throw std::runtime_error("no reference table " + name);
    std::string line;
    std::getline(file, line);
    columns_ = cells(line);
    while (std::getline(file, line)) {
      rows_.push_back(cells(line));
      if (rows_.back().size() != columns_.size()) throw std::runtime_error(name + ": " + line);
    }
  }

  std::size_t rows() const { return rows_.size(); }
  const std::string& text(std::size_t row, const std::string& column) const {
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      if (columns_[c] == column) return rows_[row][c];
    }
    throw std::runtime_error("no reference column " + column);
  }
  double at(std::size_t row, const std::string& column) const {
    return std::strtod(text(row, column).c_str(), nullptr);
  }
  /// In the first row whose `key` column holds `value`.
  double find(const std::string& key, double value, const std::string& column) const {
    for (std::size_t row = 0; row < rows(); ++row) {
      if (std::abs(at(row, key) - value) <= 1e-9 * std::abs(value)) return at(row, column);
    }
    throw std::runtime_error("no reference row where " + key + " is " + std::to_string(value));
  }

 private:
  static std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    return cells;
  }

  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace toile::test
