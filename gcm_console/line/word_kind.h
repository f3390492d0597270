#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class Option;
}

namespace console {

/// What a word of a command line names: for help, for completion, and for paths that are relative.
enum class WordKind {
  kText,
  kFile,
  kVerb,
  kParameter,  ///< of the component that stands before it
  kSetting,    ///< of the parameter that stands before it
  kArgument,   ///< of the command that stands before it, or one of its fields
  kClass,
  kPlugIn,
  kProcess,    ///< from here on: paths of a system
  kComponent,  ///< and processes on the way to one
  kPath,       ///< of anything
  kRequired,   ///< a required interface
  kProvided,
  kCommand,
  kReadable,  ///< a read command or a column
  kColumn,    ///< of a state table
  kEvent,     ///< and provided interfaces that have any
};

/// Says what the words of an option or an argument name.
CLI::Option* Names(CLI::Option* option, WordKind kind);

/// What was said of it; kText where nothing was.
WordKind KindOf(const CLI::Option& option);

[[nodiscard]] bool IsPath(WordKind kind);

/// Whether only the processes know the words.
[[nodiscard]] bool IsLive(WordKind kind);

}  // namespace console
