#pragma once

#include <gcm_console/context.h>

#include <functional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace console {

/// One verb of `gcm`: its name, what `gcm help` says of it, and how it is run. `prepare` adds its
/// options to its part of the command line and returns what runs it.
struct Verb {
  using Run = std::function<tendon::Result<program::ExitCode>(Context&)>;

  std::string name;
  std::string summary;
  std::function<Run(CLI::App&)> prepare;
};

// In groups of kindred ones.
std::vector<Verb> LookVerbs();     // ls tree show
std::vector<Verb> DataVerbs();     // get watch
std::vector<Verb> ActVerbs();      // call
std::vector<Verb> WireVerbs();     // connect disconnect undo
std::vector<Verb> ExplainVerbs();  // candidates explain
std::vector<Verb> LogVerbs();      // log log-level
std::vector<Verb> CertVerbs();     // cert
std::vector<Verb> ServeVerbs();    // serve

/// All of them: the one table that the program, its help and the window's console are made from.
std::vector<Verb> AllVerbs();

}  // namespace console
