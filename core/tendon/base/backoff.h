#pragma once

#include <chrono>

namespace tendon {

/// The pauses between attempts that fail again and again: each is twice the last one, within
/// limits. Not thread-safe.
class Backoff {
 public:
  /// `jitter`, from 0 to 1, is the largest part by which a pause is shortened at random. So
  /// programs that failed at the same time do not try again at the same time.
  constexpr Backoff(std::chrono::milliseconds shortest, std::chrono::milliseconds longest,
                    double jitter = 0.0)
      : shortest_(shortest), longest_(longest), jitter_(jitter) {}

  /// The pause after one more failure.
  [[nodiscard]] std::chrono::milliseconds Next();
  /// Call it when an attempt has succeeded, or may succeed now. The next pause is the shortest.
  void Reset() { last_ = {}; }
  /// True if Next() was called since the last Reset().
  [[nodiscard]] bool has_begun() const { return last_.count() > 0; }

 private:
  std::chrono::milliseconds shortest_;
  std::chrono::milliseconds longest_;
  double jitter_;
  std::chrono::milliseconds last_{0};  // without the jitter; 0: none
};

}  // namespace tendon
