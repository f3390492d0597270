#include <support/simulation/fiber.h>
#include <ucontext.h>

#include <cassert>
#include <cstdint>
#include <utility>
#include <vector>

#ifdef __SANITIZE_THREAD__
extern "C" {
void* __tsan_get_current_fiber();                    // NOLINT
void* __tsan_create_fiber(unsigned flags);           // NOLINT
void __tsan_destroy_fiber(void* fiber);              // NOLINT
void __tsan_switch_to_fiber(void* fiber, unsigned);  // NOLINT
}
#endif

namespace tendon {
namespace {

/// Tells ThreadSanitizer, if the program uses it, which stack is running.
class SanitizedStack {
 public:
#ifdef __SANITIZE_THREAD__
  SanitizedStack() : fiber_(__tsan_create_fiber(0)) {}
  ~SanitizedStack() { __tsan_destroy_fiber(fiber_); }
  void Enter() {
    caller_ = __tsan_get_current_fiber();
    __tsan_switch_to_fiber(fiber_, 0);
  }
  void Leave() { __tsan_switch_to_fiber(caller_, 0); }

 private:
  void* fiber_;
  void* caller_ = nullptr;
#else
  void Enter() {}
  void Leave() {}
#endif
};

/// Stacks for reuse: an exploration creates about a million fibers.
std::vector<std::vector<std::byte>>& FreeStacks() {
  static thread_local std::vector<std::vector<std::byte>> stacks;
  return stacks;
}

std::vector<std::byte> TakeStack() {
  constexpr std::size_t kStackSize = std::size_t{256} << 10;
  auto& free = FreeStacks();
  if (free.empty()) return std::vector<std::byte>(kStackSize);
  auto stack = std::move(free.back());
  free.pop_back();
  return stack;
}

}  // namespace

struct Fiber::Context {
  std::vector<std::byte> stack = TakeStack();
  ucontext_t inside{};
  ucontext_t outside{};
  SanitizedStack sanitized;

  Context() = default;
  ~Context() { FreeStacks().push_back(std::move(stack)); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
};

Fiber::Fiber(std::function<void()> body)
    : body_(std::move(body)), context_(std::make_unique<Context>()) {
  getcontext(&context_->inside);
  context_->inside.uc_stack.ss_sp = context_->stack.data();
  context_->inside.uc_stack.ss_size = context_->stack.size();
  context_->inside.uc_link = nullptr;
  const auto self = reinterpret_cast<std::uintptr_t>(this);  // makecontext() takes integers
  makecontext(&context_->inside, reinterpret_cast<void (*)()>(&Fiber::Enter), 2,
              static_cast<unsigned>(self >> 32), static_cast<unsigned>(self));
}

Fiber::~Fiber() = default;

void Fiber::Enter(unsigned high, unsigned low) {
  auto& self = *reinterpret_cast<Fiber*>(std::uintptr_t{high} << 32 | low);
  self.body_();
  self.has_ended_ = true;
  self.Yield();
}

void Fiber::Resume() {
  assert(!has_ended_);
  context_->sanitized.Enter();
  swapcontext(&context_->outside, &context_->inside);
}

void Fiber::Yield() {
  context_->sanitized.Leave();
  swapcontext(&context_->inside, &context_->outside);
}

}  // namespace tendon
