#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class Option;
}

namespace console {

/// What a word of a command line names: used by help, completion and relative paths.
enum class WordKind {
  kText,
  kFile,
  kVerb,
  kParameter,  ///< of the component that precedes it
  kSetting,    ///< of the parameter that precedes it
  kArgument,   ///< of the command that precedes it, or one of its fields
  kClass,
  kPlugIn,
  kProcess,    ///< from here on: paths of a system
  kComponent,  ///< also processes on the way to one
  kPath,       ///< of anything
  kRequired,   ///< a required interface
  kProvided,
  kCommand,
  kReadable,  ///< a read command or a column
  kColumn,    ///< of a state table
  kEvent,     ///< also provided interfaces with events
};

/// Declares what the words of an option or argument name.
CLI::Option* Names(CLI::Option* option, WordKind kind);

/// The declared kind; kText if there is none.
WordKind KindOf(const CLI::Option& option);

[[nodiscard]] bool IsPath(WordKind kind);

/// True if only the processes know the words.
[[nodiscard]] bool IsLive(WordKind kind);

}  // namespace console
