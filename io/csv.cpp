#include "io/csv.h"

#include <csv.h>

#include <algorithm>

#include "geometry/error.h"

namespace toile {

namespace {

/// libcsv's parser, and what it has given so far.
class Parser {
 public:
  Parser() { csv_init(&parser_, CSV_STRICT | CSV_STRICT_FINI); }
  ~Parser() { csv_free(&parser_); }
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;

  /// Takes a line with its end, or the last without. Whether it could be read.
  bool take(std::string_view line, int number) {
    line_ = number;
    return csv_parse(&parser_, line.data(), line.size(), on_field, on_row, this) == line.size();
  }
  bool finish() { return csv_fini(&parser_, on_field, on_row, this) == 0; }
  /// Where the row begins that is not yet whole.
  int first_line() const { return row_.fields.empty() && !is_inside_ ? line_ : row_.line; }
  /// Says that the row goes on in the next line.
  void note_start() {
    if (!is_inside_) row_.line = line_;
    is_inside_ = true;
  }

  std::vector<CsvRow> rows;

 private:
  static void on_field(void* text, std::size_t size, void* self) {
    auto* parser = static_cast<Parser*>(self);
    parser->note_start();
    parser->row_.fields.emplace_back(static_cast<const char*>(text), size);
  }
  static void on_row(int /*end*/, void* self) {
    auto* parser = static_cast<Parser*>(self);
    parser->rows.push_back(std::move(parser->row_));
    parser->row_ = {};
    parser->is_inside_ = false;
  }

  csv_parser parser_ = {};
  CsvRow row_;
  int line_ = 0;
  bool is_inside_ = false;  // a row has begun
};

}  // namespace

std::vector<CsvRow> parse_csv(std::string_view text, const std::string& name) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  Parser parser;
  const auto fail = [&](int line) {
    throw Error(name + ":" + std::to_string(line), "has a quote that is not where it may be",
                "put a field with quotes in quotes, and write each quote in it twice");
  };
  int line = 0;
  while (!text.empty()) {
    const std::size_t size = std::min(text.find('\n'), text.size() - 1) + 1;
    const std::string_view whole = text.substr(0, size);
    const std::size_t rows = parser.rows.size();
    if (!parser.take(whole, ++line)) fail(line);
    // No row ended: the line is empty, or a field in quotes goes on.
    const bool is_empty = whole.find_first_not_of(" \t\r\n") == std::string_view::npos;
    if (parser.rows.size() == rows && !is_empty) parser.note_start();
    text.remove_prefix(size);
  }
  if (!parser.finish()) fail(parser.first_line());
  return std::move(parser.rows);
}

std::string csv_field(std::string_view text) {
  const bool has_edge_space = !text.empty() && (text.front() == ' ' || text.back() == ' ' ||
                                                text.front() == '\t' || text.back() == '\t');
  if (!has_edge_space && text.find_first_of(",\"\r\n") == std::string_view::npos) {
    return std::string(text);
  }
  std::string field(csv_write(nullptr, 0, text.data(), text.size()), '\0');
  csv_write(field.data(), field.size(), text.data(), text.size());
  return field;
}

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) line += ',';
    line += csv_field(fields[i]);
  }
  return line + '\n';
}

}  // namespace toile
