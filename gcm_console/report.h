#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace console {

/// Rows with a title for each column. On a terminal they are aligned under their titles, those that
/// are too long for it in several lines; into a pipe they are separated by tabs, for scripts.
class Table {
 public:
  explicit Table(std::vector<std::string> titles) : titles_(std::move(titles)) {}

  /// As many cells as there are titles.
  void Add(std::vector<std::string> row);
  /// `columns` is the terminal's width, 0 where there is none.
  void Print(std::ostream& out, int columns) const;

 private:
  std::vector<std::string> titles_;
  std::vector<std::vector<std::string>> rows_;
};

/// The same text with control characters spelt out, so that a name from outside cannot steer the
/// terminal.
std::string Plain(const std::string& text);

}  // namespace console
