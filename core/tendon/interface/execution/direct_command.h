#pragma once

#include <tendon/interface/command.h>
#include <tendon/interface/execution/component_access.h>

#include <utility>

namespace tendon {

/// Runs `body(in, out) -> Status` in the caller's thread, for reads and thread-safe methods. If
/// `body` throws, the caller gets kFailed, and `component`, unless it is null, gets a report.
template <Payload In, Payload Out, typename Body>
class DirectCommand final : public Command<In, Out> {
 public:
  explicit DirectCommand(Body body, const ComponentAccess* component = nullptr)
      : body_(std::move(body)), component_(component) {}

  Status Execute(const In& in, Out& out) override {
    return ComponentAccess::CatchExceptions(component_, [&]() -> Status { return body_(in, out); });
  }

 private:
  Body body_;
  const ComponentAccess* component_;
};

}  // namespace tendon
