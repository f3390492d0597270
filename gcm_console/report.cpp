#include <gcm_console/report.h>

#include <algorithm>
#include <ostream>

namespace console {

void Table::Print(std::ostream& out, bool on_terminal) const {
  std::vector<std::size_t> widths;
  for (std::size_t column = 0; column < titles_.size(); ++column) {
    std::size_t width = titles_[column].size();
    for (const auto& row : rows_) width = std::max(width, Plain(row[column]).size());
    widths.push_back(width);
  }
  const auto print_row = [&](const std::vector<std::string>& row) {
    for (std::size_t column = 0; column < row.size(); ++column) {
      const std::string cell = Plain(row[column]);
      const bool is_last = column + 1 == row.size();
      out << cell;
      if (is_last) continue;
      out << (on_terminal ? std::string(widths[column] - cell.size() + 2, ' ') : "\t");
    }
    out << '\n';
  };
  if (on_terminal) print_row(titles_);
  for (const auto& row : rows_) print_row(row);
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
