#pragma once

namespace tendon::os {

/// Owns a file descriptor, which may be none (below 0), and closes it at the end.
class Descriptor {
 public:
  explicit Descriptor(int value) noexcept : value_(value) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { Close(); }

  [[nodiscard]] int get() const noexcept { return value_; }
  /// Closes it earlier; from then on there is none. A second call does nothing.
  void Close() noexcept;

 private:
  int value_;
};

}  // namespace tendon::os
