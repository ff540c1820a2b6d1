// A DXF file as what its lines say: groups of a code and a value, and the records that they make
// up.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace toile {

/// `text` without white space at its ends.
std::string_view dxf_trimmed(std::string_view text);

/// A code and its value, two lines of the file. The value is a part of the text that was read.
struct DxfGroup {
  int code = 0;
  std::string_view value;
  int line = 0;  ///< of the value, from 1
};

/// The groups of one entity, from its type to the next one.
struct DxfRecord {
  std::string_view type;
  int line = 0;  ///< of the type, from 1
  std::vector<DxfGroup> groups;
};

/// The groups of a file, one after the other. Comments (code 999) are passed over. Whatever can't
/// be read throws Error with `name` and the line. `text` and `name` must outlive it.
class DxfGroups {
 public:
  DxfGroups(std::string_view text, const std::string& name);

  /// The group at hand; none before the first next().
  const DxfGroup& now() const { return now_; }
  bool is(int code, std::string_view value) const;

  /// Goes on by one group.
  void next();

  /// Reads from the group at hand, the type of an entity, up to the next group of code 0.
  DxfRecord record();

  /// The value of a group as a finite number.
  double number(const DxfGroup& group) const;

  /// The same, not beyond 1e9 units.
  double coordinate(const DxfGroup& group) const;

  /// The same as a whole number, cut to +-1e9.
  int integer(const DxfGroup& group) const;

  /// Throws Error at the line of the group at hand.
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const;

  /// Throws Error at `line`.
  [[noreturn]] void fail_at(int line, const std::string& problem,
                            const std::string& remedy = "correct the entity or remove it") const;

 private:
  std::string_view line(const char* what);

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  int line_ = 0;
  DxfGroup now_;
};

}  // namespace toile
