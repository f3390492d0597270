#pragma once

#include <tendon/manager/description.h>

#include <cstddef>
#include <unordered_map>

namespace tendon {

/// Lets components whose interfaces or tables are equal hold them once: a thousand components of
/// one class cost little more than one. Not thread-safe.
class DescriptionPool {
 public:
  /// Costs about one look at each member.
  void Share(ComponentDescription& component);

  /// Different lists that it knows.
  [[nodiscard]] std::size_t size() const;

 private:
  /// By a hash of the content. Of several with one hash, one is known.
  template <typename T>
  struct Lists {
    std::unordered_map<std::size_t, SharedList<T>> by_hash;
    std::size_t drop_at = 64;  // entries, when those go that nobody else holds

    void Share(SharedList<T>& list);
  };

  Lists<ProvidedDescription> provided_;
  Lists<RequiredDescription> required_;
  Lists<TableDescription> tables_;
};

}  // namespace tendon
