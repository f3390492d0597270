#pragma once

#include <gcm_console/command_line/help_page.h>

#include <string>
#include <vector>

namespace console {

/// A help page about a subject other than a verb: "exit-codes", "paths", "output".
struct Topic {
  std::string name;
  std::string summary;
  /// A line has two cells; a paragraph is a line with one cell.
  std::vector<std::vector<std::string>> lines;
};

const std::vector<Topic>& Topics();

/// Formats the page for a terminal of this width; 0 stands for 80 columns.
std::string HelpText(const Page& page, int columns);
std::string HelpText(const Topic& topic, int columns);

/// The name of the manual page: "gcm-watch".
[[nodiscard]] std::string ManualName(const Page& page);
/// The page as a manual page for `man`, section 1. The page of `gcm` itself includes the topics.
std::string ManualPage(const Page& page, const std::string& version);

}  // namespace console
