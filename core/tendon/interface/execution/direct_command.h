#pragma once

#include <tendon/interface/command.h>

#include <utility>

namespace tendon {

/// Runs `body(in, out) -> Status` in the caller's thread: reads, and what is safe in any thread.
template <Payload In, Payload Out, typename Body>
class DirectCommand final : public Command<In, Out> {
 public:
  explicit DirectCommand(Body body) : body_(std::move(body)) {}

  Status Execute(const In& in, Out& out) override {
    try {
      return body_(in, out);
    } catch (...) {
      return Status::kFailed;
    }
  }

 private:
  Body body_;
};

}  // namespace tendon
