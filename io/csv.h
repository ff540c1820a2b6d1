// Tables as comma-separated values (RFC 4180), by libcsv.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace toile {

struct CsvRow {
  int line = 0;  ///< of the file, from 1, where the row begins
  std::vector<std::string> fields;
};

/// All rows of a table, the header among them. Rows need not have as many fields as the first.
/// Empty lines, a byte order mark and spaces around fields without quotes are left out.
///
/// Throws Error with the place "name:line" for a quote in a field without quotes. The same goes for
/// text after a closing quote, and for a quote that is not closed.
std::vector<CsvRow> parse_csv(std::string_view text, const std::string& name);

/// A field as a table holds it: as it is, or in quotes where it needs them.
std::string csv_field(std::string_view text);

/// A row with its line end.
std::string csv_line(const std::vector<std::string>& fields);

}  // namespace toile
