#pragma once

#include <tendon/interface/command.h>
#include <tendon/interface/execution/call_observer.h>
#include <tendon/interface/execution/component_access.h>

#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace tendon {

/// Runs `body(in, out) -> Status` in the caller's thread, for reads and thread-safe methods. If
/// `body` throws, the caller gets kFailed, and `component`, unless it is null, gets a report.
/// Observers of `offer`, which may be null, see the calls of methods, but not the reads.
template <Payload In, Payload Out, typename Body>
class DirectCommand final : public Command<In, Out> {
 public:
  explicit DirectCommand(Body body, const ComponentAccess* component = nullptr,
                         [[maybe_unused]] const CallSwitches* offer = nullptr)
      : body_(std::move(body)), component_(component) {
    if constexpr (kIsMethod) observer_ = CallObserver(offer);
  }

  Status Execute(const In& in, Out& out) override {
    return ComponentAccess::CatchExceptions(component_, [&]() -> Status {
      if constexpr (kIsMethod) {
        if (observer_.is_on()) {
          Status status = Status::kDone;
          observer_.ShowExecution(in, out, [&] { status = body_(in, out); });
          return status;
        }
      }
      return body_(in, out);
    });
  }

  void SetClient([[maybe_unused]] const std::shared_ptr<const std::string>& client) override {
    if constexpr (kIsMethod) observer_.SetClient(client);
  }

 private:
  static constexpr bool kIsMethod = std::is_same_v<Out, None>;
  struct NoObserver {};

  Body body_;
  const ComponentAccess* component_;
  [[no_unique_address]] std::conditional_t<kIsMethod, CallObserver, NoObserver> observer_;
};

}  // namespace tendon
