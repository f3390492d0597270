#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tendon {

/// Makes untrusted text safe for a terminal and a log. Control characters and invalid UTF-8 become
/// `\xNN`. Text longer than `most` bytes is cut, and "..." follows.
[[nodiscard]] std::string Printable(std::string_view text, std::size_t most = 4096);

/// Returns Printable(text, most) between single quotes, for names in messages.
[[nodiscard]] inline std::string Quoted(std::string_view text, std::size_t most = 4096) {
  return "'" + Printable(text, most) + "'";
}

/// Returns the text in lower case. Converts only ASCII letters, in every locale.
[[nodiscard]] std::string InLowerCase(std::string_view text);

/// Returns "1 row", "0 rows", "12 rows".
[[nodiscard]] inline std::string Counted(std::uint64_t count, const std::string& one,
                                         const std::string& several) {
  return std::to_string(count) + " " + (count == 1 ? one : several);
}

/// Returns the words with `separator` between them: "a, b" for {"a", "b"} and ", ". Empty if there
/// are no words.
template <typename Words>
[[nodiscard]] std::string Joined(const Words& words, const std::string& separator) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : separator) + word;
  return all;
}

/// Returns "250 ms": whole milliseconds, rounded towards zero.
template <typename Rep, typename Period>
[[nodiscard]] std::string Milliseconds(std::chrono::duration<Rep, Period> time) {
  using std::chrono::milliseconds;
  return std::to_string(std::chrono::duration_cast<milliseconds>(time).count()) + " ms";
}

/// Returns the list element that has this `name`, or null. Searches linearly.
template <typename List>
[[nodiscard]] const typename List::value_type* FindNamed(const List& elements,
                                                         const std::string& name) {
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const auto& element) { return element.name == name; });
  return found == elements.end() ? nullptr : &*found;
}

}  // namespace tendon
