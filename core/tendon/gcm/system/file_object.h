#pragma once

#include <tendon/base/name.h>
#include <tendon/payload/json/strict_json.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// Readers for files that people write. A mistake in a file is thrown as a FileError, which
/// ReadWith() or the reader catches.
namespace tendon::file {

/// A mistake in a file, and the path of its place: "processes[0].name".
struct FileError {
  std::string place;
  std::string text;  ///< begins with a path
};

/// "processes[0]: key 'name' is missing".
[[noreturn]] void Refuse(const std::string& place, const std::string& reason);

/// "string 'fast'", "number", "a list".
[[nodiscard]] std::string Shown(const Json& value);

/// One JSON object in a file, and its path.
class FileObject {
 public:
  /// Refuses a value that is not an object, or an object with a key that is not in `keys`.
  FileObject(const Json& object, std::string place, const std::vector<std::string>& keys);

  /// The path of a member.
  [[nodiscard]] std::string Place(const std::string& key) const;
  /// Null if it is missing.
  [[nodiscard]] const Json* Find(const std::string& key) const;
  void Require(const std::string& key) const;

  // Readers of a required member.

  [[nodiscard]] const Json& Get(const std::string& key) const;
  [[nodiscard]] std::string Text(const std::string& key) const;
  /// `what` is the kind of name.
  [[nodiscard]] std::string Name(const std::string& key, const std::string& what) const;
  [[nodiscard]] InterfaceName Interface(const std::string& key) const;

  // Readers of an optional member.

  /// Empty if it is missing; escapes control characters.
  [[nodiscard]] std::string Comment() const;
  /// `unit` appears in the error: "seconds".
  [[nodiscard]] double Number(const std::string& key, const std::string& unit,
                              double otherwise) const;
  /// False if it is missing.
  [[nodiscard]] bool Flag(const std::string& key) const;
  /// s; 0 if it is missing.
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

/// The names of one list, which must be unique.
class UniqueNames {
 public:
  /// `what` is the kind of name.
  explicit UniqueNames(std::string what) : what_(std::move(what)) {}

  /// Refuses a name that was added before.
  void Add(const std::string& name, const std::string& place);

 private:
  const std::string what_;
  std::set<std::string> known_;
};

/// A member with the class name of a component.
[[nodiscard]] std::string ReadClassName(const FileObject& object, const std::string& key);

/// The text of a component's configuration: one line of ASCII. Refuses a value that is not an
/// object or is too long.
[[nodiscard]] std::string ConfigurationText(const Json& configuration, const std::string& place);

/// Refuses anything except a plug-in name without a path.
void CheckLibrary(const std::string& library, const std::string& place);

/// The error for a mistake in the text of `source`.
[[nodiscard]] Error ErrorOf(const FileError& mistake, std::string_view text,
                            const std::string& source);

/// The result of `read` on the text, or the error for its mistake.
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
