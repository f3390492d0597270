#pragma once

#include <chrono>

namespace tendon {

/// Computes the pauses between attempts that fail again and again. Each pause is twice the last
/// one, within limits. Not thread-safe.
class Backoff {
 public:
  /// Each pause is shortened at random, by at most the part `jitter` (0 to 1) of its length.
  /// Therefore, programs that failed at the same time do not try again at the same time.
  constexpr Backoff(std::chrono::milliseconds shortest, std::chrono::milliseconds longest,
                    double jitter = 0.0)
      : shortest_(shortest), longest_(longest), jitter_(jitter) {}

  /// Returns the pause after one more failure.
  [[nodiscard]] std::chrono::milliseconds Next();
  /// Makes the next pause the shortest. Call it when an attempt has succeeded or may succeed now.
  void Reset() { last_ = {}; }
  /// True if Next() was called since the last Reset().
  [[nodiscard]] bool has_begun() const { return last_.count() > 0; }

 private:
  std::chrono::milliseconds shortest_;
  std::chrono::milliseconds longest_;
  double jitter_;
  std::chrono::milliseconds last_{0};  // the last pause, without jitter; 0 before the first pause
};

/// The pauses before another attempt to reach a process, or the GCM, whose link is lost.
inline constexpr Backoff kLinkRetry{std::chrono::milliseconds(100), std::chrono::milliseconds(2000),
                                    0.5};

}  // namespace tendon
