#pragma once

#include <tendon/base/name.h>
#include <tendon/payload/json/strict_json.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// For readers of files that people write: what is wrong in one is thrown as a FileMistake, which
/// never leaves the reader.
namespace tendon::file {

/// What is wrong, and the path of where: "processes[0].name".
struct FileMistake {
  std::string place;
  std::string text;  ///< begins with a path
};

/// "processes[0]: key 'name' is missing".
[[noreturn]] void Refuse(const std::string& place, const std::string& reason);

/// "string 'fast'", "number", "a list".
[[nodiscard]] std::string Shown(const Json& value);

/// One object of a file, with its path in it.
class FileObject {
 public:
  /// Refuses what is no object, and one with a key that is not among these.
  FileObject(const Json& object, std::string place, const std::vector<std::string>& keys);

  /// The path of a member.
  [[nodiscard]] std::string Place(const std::string& key) const;
  /// Null where it is missing.
  [[nodiscard]] const Json* Find(const std::string& key) const;
  void Require(const std::string& key) const;

  // Of a member that must be there.

  [[nodiscard]] const Json& Get(const std::string& key) const;
  [[nodiscard]] std::string Text(const std::string& key) const;
  /// `what` it is the name of.
  [[nodiscard]] std::string Name(const std::string& key, const std::string& what) const;
  [[nodiscard]] InterfaceName Interface(const std::string& key) const;

  // Of one that may be missing.

  /// Empty where it is missing; control characters are spelt out.
  [[nodiscard]] std::string Comment() const;
  /// `unit` is for the error: "seconds".
  [[nodiscard]] double Number(const std::string& key, const std::string& unit,
                              double otherwise) const;
  /// False where it is missing.
  [[nodiscard]] bool Flag(const std::string& key) const;
  /// s; 0 where it is missing.
  [[nodiscard]] double Period(const std::string& key) const;
  /// Calls `read(element, place)` for each; a missing list is empty.
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

/// The names of one list.
class NewNames {
 public:
  /// `what` they are names of.
  explicit NewNames(std::string what) : what_(std::move(what)) {}

  /// Refuses one that was added before.
  void Add(const std::string& name, const std::string& place);

 private:
  const std::string what_;
  std::set<std::string> known_;
};

/// A member that is the name of a component's class.
[[nodiscard]] std::string ReadClassName(const FileObject& object, const std::string& key);

/// A configuration as a component keeps it, in one line of ASCII. Refuses what is no object, and
/// one that is too long.
[[nodiscard]] std::string ConfigurationText(const Json& configuration, const std::string& place);

/// Refuses what is no bare name of a plug-in.
void CheckLibrary(const std::string& library, const std::string& place);

/// The error for a mistake in a text from this source.
[[nodiscard]] Error ErrorOf(const FileMistake& mistake, std::string_view text,
                            const std::string& source);

/// What `read` makes of the text, or the error of its mistake.
template <typename T, typename Read>
Result<T> ReadText(std::string_view text, const std::string& source, Read&& read) {
  const auto json = ParseStrictJson(text);
  if (!json) return Error{ErrorCode::kInvalid, source + ": " + json.error().message};
  try {
    return std::forward<Read>(read)(*json);
  } catch (const FileMistake& mistake) {
    return ErrorOf(mistake, text, source);
  }
}

}  // namespace tendon::file
