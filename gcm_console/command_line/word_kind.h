#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class Option;
}

namespace console {

/// The kind of object that a word of a command line names. Used for help, for completion, and to
/// find relative paths.
enum class WordKind {
  kText,
  kFile,
  kVerb,
  kParameter,  ///< a parameter of the component in the previous word
  kSetting,    ///< a value of the parameter in the previous word
  kArgument,   ///< an argument of the command in the previous word, or one field of the argument
  kClass,
  kPlugIn,
  kProcess,    ///< this and all later kinds are paths of a system
  kComponent,  ///< completion also offers processes
  kPath,       ///< path of any object
  kRequired,   ///< a required interface
  kProvided,
  kCommand,
  kReadable,  ///< a read command or a column
  kColumn,    ///< a column of a state table
  kEvent,     ///< an event, a command, or a provided interface with events
};

/// Declares which kind of words an option or argument accepts.
CLI::Option* WithKind(CLI::Option* option, WordKind kind);

/// Returns the declared kind; kText if none was declared.
WordKind KindOf(const CLI::Option& option);

[[nodiscard]] bool IsPath(WordKind kind);

/// Returns true if words of this kind are known only to the processes.
[[nodiscard]] bool IsLive(WordKind kind);

}  // namespace console
