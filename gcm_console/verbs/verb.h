#pragma once

#include <gcm_console/command_line/word_kind.h>
#include <gcm_console/context.h>

#include <functional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace console {

// Names that every verb uses.
using program::ExitCode;
using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;

/// One verb of `gcm`, with its name, its help and its function. `prepare` adds the options, each
/// with its WordKind, to the verb's part of the command line. It returns the function that runs the
/// verb.
struct Verb {
  using Run = std::function<Result<ExitCode>(Context&)>;

  std::string name;
  std::string summary;
  std::function<Run(CLI::App&)> prepare;
  std::vector<std::string> examples = {};  ///< whole command lines
  std::string group = {};                  ///< as in verb_table.cpp
};

// The verbs of each subject.
std::vector<Verb> LookVerbs();        // ls tree
std::vector<Verb> ShowVerbs();        // show
std::vector<Verb> FindVerbs();        // status find graph
std::vector<Verb> TopVerbs();         // top
std::vector<Verb> PlotVerbs();        // plot
std::vector<Verb> DoctorVerbs();      // doctor
std::vector<Verb> DataVerbs();        // get watch
std::vector<Verb> EventVerbs();       // events
std::vector<Verb> RateVerbs();        // hz
std::vector<Verb> ActVerbs();         // call
std::vector<Verb> ClassVerbs();       // load classes create configure
std::vector<Verb> SetVerbs();         // set
std::vector<Verb> LifecycleVerbs();   // start suspend stop restart rm
std::vector<Verb> ConnectionVerbs();  // connect disconnect
std::vector<Verb> ExplainVerbs();     // candidates explain
std::vector<Verb> HistoryVerbs();     // undo history
std::vector<Verb> SystemVerbs();      // save import diff plan apply
std::vector<Verb> LogVerbs();         // log log-level
std::vector<Verb> RecordVerbs();      // record
std::vector<Verb> PastVerbs();        // save-last
std::vector<Verb> FileVerbs();        // info recover cut export
std::vector<Verb> ReplayVerbs();      // replay
std::vector<Verb> CertVerbs();        // cert
std::vector<Verb> ServeVerbs();       // serve broker
std::vector<Verb> ShellVerbs();       // shell run
std::vector<Verb> MetaVerbs();        // help version completion

/// Returns the table of all verbs. The program, its help, its manual pages, the completion and the
/// shell use this table.
std::vector<Verb> AllVerbs();

}  // namespace console
