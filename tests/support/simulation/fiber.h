#pragma once

#include <functional>
#include <memory>

namespace tendon {

/// A function with a stack of its own, run in turns with its caller in one thread.
class Fiber {
 public:
  explicit Fiber(std::function<void()> body);
  /// The body should have ended: what lies on the stack of one that has not is leaked.
  ~Fiber();
  Fiber(const Fiber&) = delete;
  Fiber& operator=(const Fiber&) = delete;

  /// Runs the body until it yields or ends. Not from inside a fiber.
  void Resume();
  /// From inside the body: returns to the caller of Resume().
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
