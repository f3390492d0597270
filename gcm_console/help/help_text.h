#pragma once

#include <gcm_console/help/page.h>

#include <string>
#include <vector>

namespace console {

/// What explains a matter that is no verb: "exit-codes", "paths", "output".
struct Topic {
  std::string name;
  std::string summary;
  /// Lines with two cells each; a line with one is a paragraph.
  std::vector<std::vector<std::string>> lines;
};

const std::vector<Topic>& Topics();

/// For a terminal of so many columns, 0 for the usual 80.
std::string HelpText(const Page& page, int columns);
std::string HelpText(const Topic& topic, int columns);

/// What the manual page is called: "gcm-watch".
[[nodiscard]] std::string ManualName(const Page& page);
/// The page as a manual page for `man`, of section 1. The page of `gcm` itself has the topics, too.
std::string ManualPage(const Page& page, const std::string& version);

}  // namespace console
