// Reads words and numbers from a text line by line. Its errors name the line.
#pragma once

#include <string>
#include <string_view>

namespace toile {

/// Reads a text line by line and word by word. Every Error it throws has the place "name:line". The
/// text has to outlive it.
class LineScanner {
 public:
  LineScanner(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  /// Goes on to the next line that is not blank. The rest of a line from the character `comment` on
  /// is dropped, unless that is 0. False at the end of the text. Lines end in LF, CR or CR LF.
  bool next_line(char comment = 0);
  /// Goes on as next_line(). The end of the text is an Error: "the file ends before <what>".
  void need_line(const std::string& what, char comment = 0);

  /// The next word of the line; empty at its end.
  std::string_view word();
  /// The rest of the line.
  std::string_view rest() const { return line_; }
  /// The next word as a finite number. `what` names it in an Error.
  double number(const std::string& what);
  /// The next word as a coordinate, which is an Error beyond max_coordinate.
  double coordinate();
  /// The next word as an integer from `low` to `high`. `what` names it in an Error.
  long long integer(const std::string& what, long long low, long long high);

  /// Where the line is: "name:line".
  std::string place() const;
  /// Number of bytes before the next line.
  std::size_t offset() const { return at_; }

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const;

 private:
  std::string_view text_;
  std::string name_;
  std::string_view line_;
  std::size_t at_ = 0;
  int number_ = 0;
};

/// A word as messages show it: in quotes, cut at 40 characters, with '?' for unprintable ones.
std::string shown(std::string_view word);

}  // namespace toile
