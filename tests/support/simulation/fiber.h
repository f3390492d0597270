#pragma once

#include <functional>
#include <memory>

namespace tendon {

/// A function with its own stack. It runs alternately with its caller, in one thread.
class Fiber {
 public:
  explicit Fiber(std::function<void()> body);
  /// The body should have ended before. Otherwise the objects on its stack leak.
  ~Fiber();
  Fiber(const Fiber&) = delete;
  Fiber& operator=(const Fiber&) = delete;

  /// Runs the body until it yields or ends. Must not be called inside a fiber.
  void Resume();
  /// Called in the body: returns to the caller of Resume().
  void Yield();
  [[nodiscard]] bool has_ended() const { return has_ended_; }

 private:
  struct Context;
  static void Enter(unsigned high, unsigned low);

  std::function<void()> body_;
  std::unique_ptr<Context> context_;
  bool has_ended_ = false;
};

}  // namespace tendon
