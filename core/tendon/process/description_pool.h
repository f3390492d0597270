#pragma once

#include <tendon/manager/component_description.h>

#include <cstddef>
#include <unordered_map>

namespace tendon {

/// Shares equal interfaces and tables between components, so that a thousand components of one
/// class need little more memory than one component. Not thread-safe.
class DescriptionPool {
 public:
  /// Replaces the lists of `component` by shared lists. The cost is proportional to the number of
  /// members.
  void Share(ComponentDescription& component);

  /// The number of different lists.
  [[nodiscard]] std::size_t size() const;

 private:
  /// The shared lists, by a hash of their content. For each hash, only one list is kept.
  template <typename T>
  struct Lists {
    std::unordered_map<std::size_t, SharedList<T>> by_hash;
    std::size_t drop_at = 64;  // number of entries above which unused lists are dropped

    void Share(SharedList<T>& list);
  };

  Lists<ProvidedDescription> provided_;
  Lists<RequiredDescription> required_;
  Lists<TableDescription> tables_;
};

}  // namespace tendon
