#include <gcm_console/output/table.h>

#include <tendon/base/text.h>

#include <algorithm>
#include <functional>
#include <map>
#include <ostream>
#include <string_view>
#include <utility>

namespace console {
namespace {

using Row = std::vector<std::string>;

constexpr std::size_t kGap = 2;
constexpr std::size_t kIndent = 4;  // indentation of continuation lines

void PrintSeparated(const Row& row, const TableLayout& layout, std::ostream& out) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    out << (i == 0 ? "" : "\t") << Coloured(row[i], layout.is_coloured);
  }
  out << '\n';
}

constexpr const char* kRed = "\x1b[31m";
constexpr const char* kYellow = "\x1b[33m";
constexpr const char* kGreen = "\x1b[32m";
constexpr const char* kBold = "\x1b[1m";
constexpr const char* kUsual = "\x1b[0m";

/// The colours of the words for states.
const std::map<std::string_view, const char*> kColours = {
    {"alive", kGreen},    {"active", kGreen},   {"ok", kGreen}, {"suspect", kYellow},
    {"pending", kYellow}, {"warning", kYellow}, {"lost", kRed}, {"faulted", kRed},
    {"failed", kRed},     {"error", kRed},      {"BAD", kRed},
};

/// Returns the number of characters of a text in UTF-8.
std::size_t WidthOf(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0U) != 0x80U;
  }));
}

bool IsNumber(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789.+-e%") == std::string::npos &&
         text.find_first_of("0123456789") != std::string::npos;
}

struct Column {
  std::size_t width = 0;
  bool is_number = true;  // all cells are numbers, so the column is aligned to the right
};

std::vector<Column> ColumnsOf(const Row& titles, const std::vector<Row>& rows) {
  std::vector<Column> columns;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    Column column{.width = WidthOf(titles[i]), .is_number = !rows.empty()};
    for (const Row& row : rows) {
      column.width = std::max(column.width, WidthOf(row[i]));
      if (row[i] != "-" && !IsNumber(row[i])) column.is_number = false;
    }
    columns.push_back(column);
  }
  return columns;
}

std::string Painted(const std::string& text, const char* paint, const TableLayout& layout) {
  return layout.is_coloured ? paint + text + kUsual : text;
}

/// Prints a row in as many lines as necessary. All rows are wrapped at the same columns.
void PrintAligned(const Row& row, const std::vector<Column>& columns, const TableLayout& layout,
                  const std::function<std::string(const std::string&)>& paint, std::ostream& out) {
  std::size_t used = 0;
  std::string blanks;  // before the next cell
  bool is_empty = true;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::size_t length = WidthOf(row[i]);
    const bool is_last = i + 1 == row.size() && !columns[i].is_number;
    const std::size_t width = is_last ? length : columns[i].width;
    if (used > kIndent && used + width > static_cast<std::size_t>(layout.columns)) {
      out << '\n';
      used = kIndent;
      blanks = std::string(kIndent, ' ');
      is_empty = true;
    }
    const std::string fill(width - length, ' ');
    if (columns[i].is_number) blanks += fill;
    if (!row[i].empty()) {
      out << std::exchange(blanks, "") << paint(row[i]);
      is_empty = false;
    }
    blanks += (columns[i].is_number ? "" : fill) + std::string(kGap, ' ');
    used += width + kGap;
  }
  if (!is_empty) out << '\n';
}

}  // namespace

void Table::Add(std::vector<std::string> row) {
  for (std::string& cell : row) cell = Plain(cell);
  rows_.push_back(std::move(row));
}

void Table::Print(std::ostream& out, const TableLayout& layout) const {
  if (layout.columns == 0) {
    for (const Row& row : rows_) PrintSeparated(row, layout, out);
    return;
  }
  const auto columns = ColumnsOf(titles_, rows_);
  const auto bold = [&](const std::string& text) { return Painted(text, kBold, layout); };
  const auto plain = [&](const std::string& text) { return Coloured(text, layout.is_coloured); };
  if (layout.has_titles) PrintAligned(titles_, columns, layout, bold, out);
  for (const Row& row : rows_) PrintAligned(row, columns, layout, plain, out);
}

std::string Coloured(const std::string& text, bool is_coloured) {
  const auto colour = kColours.find(text);
  return is_coloured && colour != kColours.end() ? colour->second + text + kUsual : text;
}

std::string Plain(const std::string& text) { return tendon::Printable(text, std::string::npos); }

void PrintSentences(const std::vector<std::string>& sentences, std::ostream& err) {
  for (const std::string& sentence : sentences) err << "gcm: " << Plain(sentence) << '\n';
}

}  // namespace console
