#pragma once

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace console {

/// The ways to print a table.
struct TableLayout {
  int columns = 0;  ///< width of the terminal; 0 if there is none
  bool is_coloured = false;
  bool has_titles = true;  ///< print titles on a terminal; in a pipe there are never titles
};

/// Rows, with a title for each column. On a terminal, the cells are aligned below their titles, and
/// long rows are wrapped. In a pipe, the cells are separated by tabs, for scripts.
class Table {
 public:
  explicit Table(std::vector<std::string> titles) : titles_(std::move(titles)) {}

  /// Adds a row, which must have as many cells as there are titles.
  void Add(std::vector<std::string> row);
  void Print(std::ostream& out, const TableLayout& layout) const;
  void Print(std::ostream& out, int columns) const { Print(out, TableLayout{.columns = columns}); }

 private:
  std::vector<std::string> titles_;
  std::vector<std::vector<std::string>> rows_;
};

/// Returns the text. If the text is a word for a state, such as "active", "pending" or "lost", adds
/// the colour of the state.
std::string Coloured(const std::string& text, bool is_coloured);

/// Returns the text with its control characters escaped, so that a name from outside cannot control
/// the terminal.
std::string Plain(const std::string& text);

/// Prints each sentence in a separate line, as a message of this program.
void PrintSentences(const std::vector<std::string>& sentences, std::ostream& err);

}  // namespace console
