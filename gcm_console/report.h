#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace console {

/// How a table is printed.
struct Layout {
  int columns = 0;  ///< the terminal's width, 0 where there is none
  bool is_coloured = false;
  bool has_titles = true;  ///< on a terminal; elsewhere there are none
};

/// Rows with a title for each column. On a terminal they are aligned under their titles, those that
/// are too long for it in several lines; into a pipe they are separated by tabs, for scripts.
class Table {
 public:
  explicit Table(std::vector<std::string> titles) : titles_(std::move(titles)) {}

  /// As many cells as there are titles.
  void Add(std::vector<std::string> row);
  void Print(std::ostream& out, const Layout& layout) const;
  void Print(std::ostream& out, int columns) const { Print(out, Layout{.columns = columns}); }

 private:
  std::vector<std::string> titles_;
  std::vector<std::vector<std::string>> rows_;
};

/// The text, in the colour of what it says where it is one of the words for how things are:
/// "active", "pending", "lost".
std::string Coloured(const std::string& text, bool is_coloured);

/// The same text with control characters spelt out, so that a name from outside cannot steer the
/// terminal.
std::string Plain(const std::string& text);

}  // namespace console
