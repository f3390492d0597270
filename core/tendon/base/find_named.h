#pragma once

#include <algorithm>
#include <string>

namespace tendon {

/// The element of a list with this `name`, or null. A linear search.
template <typename List>
[[nodiscard]] const typename List::value_type* FindNamed(const List& elements,
                                                         const std::string& name) {
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const auto& element) { return element.name == name; });
  return found == elements.end() ? nullptr : &*found;
}

}  // namespace tendon
