#pragma once

#include <tendon/interface/command.h>
#include <tendon/interface/execution/host.h>

#include <utility>

namespace tendon {

/// Runs `body(in, out) -> Status` in the caller's thread: for reads and thread-safe methods. An
/// exception gives kFailed and is reported to `host`, if any.
template <Payload In, Payload Out, typename Body>
class DirectCommand final : public Command<In, Out> {
 public:
  explicit DirectCommand(Body body, const Host* host = nullptr)
      : body_(std::move(body)), host_(host) {}

  Status Execute(const In& in, Out& out) override {
    return Host::Contain(host_, [&]() -> Status { return body_(in, out); });
  }

 private:
  Body body_;
  const Host* host_;
};

}  // namespace tendon
