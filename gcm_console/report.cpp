#include <gcm_console/report.h>

#include <algorithm>
#include <ostream>

namespace console {
namespace {

using Row = std::vector<std::string>;

constexpr std::size_t kGap = 2;
constexpr std::size_t kIndent = 4;  // of what did not fit into the first line

void PrintSeparated(const Row& row, std::ostream& out) {
  for (std::size_t i = 0; i < row.size(); ++i) out << (i == 0 ? "" : "\t") << row[i];
  out << '\n';
}

/// In as many lines as it takes; what is aligned breaks at the same cells in every row.
void PrintAligned(const Row& row, const std::vector<std::size_t>& widths, std::size_t columns,
                  std::ostream& out) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const bool is_last = i + 1 == row.size();  // where nothing is aligned behind it
    const std::size_t width = is_last ? row[i].size() : widths[i];
    if (line.size() > kIndent && line.size() + width > columns) {
      out << line.substr(0, line.find_last_not_of(' ') + 1) << '\n';
      line = std::string(kIndent, ' ');
    }
    line += row[i] + std::string(width - row[i].size() + kGap, ' ');
  }
  const std::size_t end = line.find_last_not_of(' ') + 1;
  if (end > 0) out << line.substr(0, end) << '\n';
}

}  // namespace

void Table::Add(std::vector<std::string> row) {
  for (std::string& cell : row) cell = Plain(cell);
  rows_.push_back(std::move(row));
}

void Table::Print(std::ostream& out, int columns) const {
  if (columns == 0) {
    for (const Row& row : rows_) PrintSeparated(row, out);
    return;
  }
  std::vector<std::size_t> widths;
  for (std::size_t column = 0; column < titles_.size(); ++column) {
    std::size_t width = titles_[column].size();
    for (const Row& row : rows_) width = std::max(width, row[column].size());
    widths.push_back(width);
  }
  PrintAligned(titles_, widths, static_cast<std::size_t>(columns), out);
  for (const Row& row : rows_) PrintAligned(row, widths, static_cast<std::size_t>(columns), out);
}

std::string Plain(const std::string& text) {
  constexpr char kHex[] = "0123456789abcdef";
  std::string plain;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte < 0x20 || byte == 0x7f) {
      plain += {'\\', 'x', kHex[byte >> 4U], kHex[byte & 0xfU]};
    } else {
      plain += letter;
    }
  }
  return plain;
}

}  // namespace console
