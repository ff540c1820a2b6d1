// Numbers and words out of text and bytes, with the place of whatever is wrong.
#pragma once

#include <string>
#include <string_view>

namespace toile {

/// Walks through a text line by line and word by word. Every Error it throws names "name:line".
class LineScanner {
 public:
  LineScanner(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  /// Goes on to the next line that is not blank, nor a comment where `comment` is not 0.
  /// False at the end of the text. Lines end in LF, CR or CR LF.
  bool next_line(char comment = 0);
  /// As next_line(), but the end of the text is an Error: "ends before <what>".
  void need_line(const std::string& what, char comment = 0);

  /// The next word of the line; empty at its end.
  std::string_view word();
  /// What is left of the line.
  std::string_view rest() const { return line_; }
  /// The next word as a finite number; as an integer from `low` to `high`. `what` names it.
  double number(const std::string& what);
  long long integer(const std::string& what, long long low, long long high);

  /// Bytes before the next line.
  std::size_t offset() const { return at_; }
  int line() const { return number_; }

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const;

 private:
  std::string_view text_;
  std::string name_;
  std::string_view line_;
  std::size_t at_ = 0;
  int number_ = 0;
};

/// A word as messages show it: cut at 40 characters, what can't be printed as '?'.
std::string shown(std::string_view word);

}  // namespace toile
