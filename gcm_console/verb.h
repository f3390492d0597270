#pragma once

#include <gcm_console/context.h>
#include <gcm_console/line/word_kind.h>

#include <functional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace console {

// What every verb speaks of.
using program::ExitCode;
using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;

/// One verb of `gcm`: its name, what help says of it, and how it is run. `prepare` adds its options
/// to its part of the command line, each with what its words name, and returns what runs it.
struct Verb {
  using Run = std::function<Result<ExitCode>(Context&)>;

  std::string name;
  std::string summary;
  std::function<Run(CLI::App&)> prepare;
  std::vector<std::string> examples = {};  ///< whole command lines
  std::string group = {};                  ///< as verb_table.cpp says
};

// In groups of kindred ones.
std::vector<Verb> LookVerbs();       // ls tree
std::vector<Verb> ShowVerbs();       // show
std::vector<Verb> FindVerbs();       // status find graph
std::vector<Verb> TopVerbs();        // top
std::vector<Verb> PlotVerbs();       // plot
std::vector<Verb> DoctorVerbs();     // doctor
std::vector<Verb> DataVerbs();       // get watch
std::vector<Verb> EventVerbs();      // events
std::vector<Verb> RateVerbs();       // hz
std::vector<Verb> ActVerbs();        // call
std::vector<Verb> ClassVerbs();      // load classes create configure
std::vector<Verb> SetVerbs();        // set
std::vector<Verb> LifecycleVerbs();  // start suspend stop restart rm
std::vector<Verb> WireVerbs();       // connect disconnect
std::vector<Verb> ExplainVerbs();    // candidates explain
std::vector<Verb> HistoryVerbs();    // undo history
std::vector<Verb> SystemVerbs();     // save import diff plan apply
std::vector<Verb> LogVerbs();        // log log-level
std::vector<Verb> CertVerbs();       // cert
std::vector<Verb> ServeVerbs();      // serve fan-out
std::vector<Verb> ShellVerbs();      // shell run
std::vector<Verb> MetaVerbs();       // help version completion

/// All of them: the one table that the program, its help, its manual, the completion of words and
/// the shell are made from.
std::vector<Verb> AllVerbs();

}  // namespace console
