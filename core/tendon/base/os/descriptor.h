#pragma once

namespace tendon::os {

/// Owns a file descriptor and closes it in the destructor. A value below 0 means no descriptor.
class Descriptor {
 public:
  explicit Descriptor(int value) noexcept : value_(value) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { Close(); }

  [[nodiscard]] int get() const noexcept { return value_; }
  /// Closes the descriptor now. A second call does nothing.
  void Close() noexcept;

 private:
  int value_;
};

}  // namespace tendon::os
