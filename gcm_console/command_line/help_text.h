#pragma once

#include <gcm_console/command_line/help_page.h>

#include <string>
#include <vector>

namespace console {

/// A help page about a subject other than a verb: "exit-codes", "paths", "output".
struct Topic {
  std::string name;
  std::string summary;
  /// Each line is a list of cells: two cells for a term and its explanation, one cell for a
  /// paragraph.
  std::vector<std::vector<std::string>> lines;
};

const std::vector<Topic>& Topics();

/// Formats the page for a terminal of this width; with a width of 0, for 80 columns.
std::string HelpText(const Page& page, int columns);
std::string HelpText(const Topic& topic, int columns);

/// Returns the name of the manual page: "gcm-watch".
[[nodiscard]] std::string ManualName(const Page& page);
/// Returns the page as a manual page of section 1 for `man`. The page of `gcm` itself includes the
/// topics.
std::string ManualPage(const Page& page, const std::string& version);

}  // namespace console
