#pragma once

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace console {

/// How a table is printed.
struct Layout {
  int columns = 0;  ///< the terminal's width, 0 if there is none
  bool is_coloured = false;
  bool has_titles = true;  ///< titles on a terminal; there are none elsewhere
};

/// Rows with a title per column. On a terminal, aligns the cells under their titles and wraps long
/// rows; into a pipe, separates the cells with tabs, for scripts.
class Table {
 public:
  explicit Table(std::vector<std::string> titles) : titles_(std::move(titles)) {}

  /// Must have as many cells as there are titles.
  void Add(std::vector<std::string> row);
  void Print(std::ostream& out, const Layout& layout) const;
  void Print(std::ostream& out, int columns) const { Print(out, Layout{.columns = columns}); }

 private:
  std::vector<std::string> titles_;
  std::vector<std::vector<std::string>> rows_;
};

/// Adds the colour of a state to the text if it is a state word such as "active", "pending" or
/// "lost".
std::string Coloured(const std::string& text, bool is_coloured);

/// The text with escaped control characters, so that an untrusted name cannot control the terminal.
std::string Plain(const std::string& text);

/// Prints each sentence in a line of its own, as a message of this program.
void PrintSentences(const std::vector<std::string>& sentences, std::ostream& err);

}  // namespace console
