#pragma once

#include <tendon/payload/traits.h>

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace tendon {

/// A list whose copies can share its memory. Until Share() is called, it works like a std::vector.
/// From then on, a copy only increments a reference count, and a list gets its own memory when it
/// is changed. As a payload, it is a vector.
///
/// Thread safety: the same as for a std::vector; shared content is never modified.
template <typename T>
class SharedList {
 public:
  using value_type = T;
  using iterator = typename std::vector<T>::iterator;
  using const_iterator = typename std::vector<T>::const_iterator;

  SharedList() = default;
  SharedList(std::initializer_list<T> items) : own_(items) {}
  SharedList(std::vector<T> items)
      : own_(std::move(items)) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] const std::vector<T>& items() const { return shared_ ? *shared_ : own_; }
  [[nodiscard]] std::size_t size() const { return items().size(); }
  [[nodiscard]] bool empty() const { return items().empty(); }
  [[nodiscard]] const T* data() const { return items().data(); }
  [[nodiscard]] const_iterator begin() const { return items().begin(); }
  [[nodiscard]] const_iterator end() const { return items().end(); }
  [[nodiscard]] const T& operator[](std::size_t index) const { return items()[index]; }
  [[nodiscard]] const T& front() const { return items().front(); }
  [[nodiscard]] const T& back() const { return items().back(); }

  // Functions to change the list.
  [[nodiscard]] T* data() { return Own().data(); }
  [[nodiscard]] iterator begin() { return Own().begin(); }
  [[nodiscard]] iterator end() { return Own().end(); }
  [[nodiscard]] T& operator[](std::size_t index) { return Own()[index]; }
  [[nodiscard]] T& front() { return Own().front(); }
  [[nodiscard]] T& back() { return Own().back(); }
  void push_back(T item) { Own().push_back(std::move(item)); }
  void resize(std::size_t size) { Own().resize(size); }
  void clear() { *this = {}; }

  /// From now on, all copies share the memory of this list.
  void Share() {
    if (!shared_) shared_ = std::make_shared<const std::vector<T>>(std::exchange(own_, {}));
  }
  /// Returns approximately how many copies share this list; 1 before Share().
  [[nodiscard]] long holders() const { return shared_ ? shared_.use_count() : 1; }

  friend bool operator==(const SharedList& a, const SharedList& b) {
    return (a.shared_ && a.shared_ == b.shared_) || a.items() == b.items();
  }

 private:
  std::vector<T>& Own() {
    if (shared_) {
      own_ = *shared_;
      shared_.reset();
    }
    return own_;
  }

  std::vector<T> own_;  // empty while the list is shared
  std::shared_ptr<const std::vector<T>> shared_;
};

template <typename T>
struct payload::SequenceTraits<SharedList<T>> {
  using Element = T;
};

}  // namespace tendon
