#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class Option;
}

namespace console {

/// The kind of thing that a word of a command line names. Used by help, completion and relative
/// paths.
enum class WordKind {
  kText,
  kFile,
  kVerb,
  kParameter,  ///< of the component in the word before
  kSetting,    ///< of the parameter in the word before
  kArgument,   ///< of the command in the word before, or one of its fields
  kClass,
  kPlugIn,
  kProcess,    ///< this and all later kinds are paths of a system
  kComponent,  ///< completion also offers processes
  kPath,       ///< of anything
  kRequired,   ///< a required interface
  kProvided,
  kCommand,
  kReadable,  ///< a read command or a column
  kColumn,    ///< of a state table
  kEvent,     ///< or a provided interface with events
};

/// Declares the kind of the words of an option or argument.
CLI::Option* WithKind(CLI::Option* option, WordKind kind);

/// The declared kind; kText if there is none.
WordKind KindOf(const CLI::Option& option);

[[nodiscard]] bool IsPath(WordKind kind);

/// True if only the processes know the words.
[[nodiscard]] bool IsLive(WordKind kind);

}  // namespace console
