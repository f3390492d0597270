#pragma once

#include <tendon/base/name.h>
#include <tendon/payload/json/strict_json.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Functions that read files that people write. They throw a FileError for a mistake in a file.
/// ReadText() converts a FileError to an Error.
namespace tendon::file {

/// A mistake in a file. `place` is the path to the mistake: "processes[0].name".
struct FileError {
  std::string place;
  std::string text;  ///< message, which begins with a path
};

/// Throws a FileError with a message such as "processes[0]: key 'name' is missing".
[[noreturn]] void Refuse(const std::string& place, const std::string& reason);

/// Describes a value for an error message: "string 'fast'", "number", "a list".
[[nodiscard]] std::string Shown(const Json& value);

/// One JSON object in a file, and its path.
class FileObject {
 public:
  /// Throws a FileError if `object` is not a JSON object, or if it has a key that is not in `keys`.
  FileObject(const Json& object, std::string place, const std::vector<std::string>& keys);

  /// Returns the path of a member.
  [[nodiscard]] std::string Place(const std::string& key) const;
  /// Returns a member; null if it is missing.
  [[nodiscard]] const Json* Find(const std::string& key) const;
  void Require(const std::string& key) const;

  // These functions read a member that must exist.

  [[nodiscard]] const Json& Get(const std::string& key) const;
  [[nodiscard]] std::string Text(const std::string& key) const;
  /// `what` is the kind of the named object, for error messages: "component".
  [[nodiscard]] std::string Name(const std::string& key, const std::string& what) const;
  [[nodiscard]] InterfaceName Interface(const std::string& key) const;

  // These functions read a member that may be missing.

  /// Returns the text of the member "comment", with control characters escaped; empty if there is
  /// none.
  [[nodiscard]] std::string Comment() const;
  /// Returns `otherwise` if the number is missing. `unit` is for the error message: "seconds".
  [[nodiscard]] double Number(const std::string& key, const std::string& unit,
                              double otherwise) const;
  /// Returns false if the flag is missing.
  [[nodiscard]] bool Flag(const std::string& key) const;
  /// Returns a period in s; 0 if the member is missing.
  [[nodiscard]] double Period(const std::string& key) const;
  /// Calls `read(element, place)` for each element; a missing list is empty.
  template <typename Read>
  void ForEach(const std::string& key, Read&& read) const {
    const Json* list = Find(key);
    if (list == nullptr) return;
    if (!list->is_array()) Refuse(Place(key), "expected a list, got " + Shown(*list));
    std::size_t index = 0;
    for (const Json& element : *list)
      read(element, Place(key) + "[" + std::to_string(index++) + "]");
  }

 private:
  const Json& object_;
  const std::string place_;
};

/// Checks that the names in one list are unique.
class UniqueNames {
 public:
  /// `what` is the kind of the named objects, for error messages: "component".
  explicit UniqueNames(std::string what) : what_(std::move(what)) {}

  /// Throws a FileError if the name was added before.
  void Add(const std::string& name, const std::string& place);

 private:
  const std::string what_;
  std::set<std::string> known_;
};

/// Reads the member that has the class name of a component.
[[nodiscard]] std::string ReadClassName(const FileObject& object, const std::string& key);

/// Returns the configuration of a component as one line of ASCII. Throws a FileError if it is not
/// an object or is too long.
[[nodiscard]] std::string ConfigurationText(const Json& configuration, const std::string& place);

/// Throws a FileError if `library` is not the name of a plug-in without a path.
void CheckLibrary(const std::string& library, const std::string& place);

/// Converts a mistake to an error with the line and column in `text`; `source` is the name of the
/// file.
[[nodiscard]] Error ErrorOf(const FileError& mistake, std::string_view text,
                            const std::string& source);

/// Parses the JSON text and returns the result of `read(json)`. If `read` throws a FileError,
/// returns the error for it.
template <typename T, typename Read>
Result<T> ReadText(std::string_view text, const std::string& source, Read&& read) {
  const auto json = ParseStrictJson(text);
  if (!json) return Error{ErrorCode::kInvalid, source + ": " + json.error().message};
  try {
    return std::forward<Read>(read)(*json);
  } catch (const FileError& mistake) {
    return ErrorOf(mistake, text, source);
  }
}

}  // namespace tendon::file
