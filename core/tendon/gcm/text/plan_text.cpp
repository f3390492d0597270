#include <tendon/gcm/system/plan.h>

namespace tendon {
namespace {

using Kind = PlanStep::Kind;

/// " (SimulatedArm of simulated_arm)".
std::string Origin(const SystemFile::Component& component) {
  const std::string from = component.library.empty() ? "" : " of " + component.library;
  const std::string after =
      component.runs_after.empty() ? "" : ", which runs after " + component.runs_after;
  return " (" + component.class_name + from + after + ")";
}

}  // namespace

std::string_view ToString(PlanStep::Kind kind) {
  switch (kind) {
    case Kind::kStop:
      return "stop";
    case Kind::kSuspend:
      return "suspend";
    case Kind::kDisconnect:
      return "disconnect";
    case Kind::kRemove:
      return "remove";
    case Kind::kStartProcess:
      return "start-process";
    case Kind::kConfigure:
      return "configure";
    case Kind::kCreate:
      return "create";
    case Kind::kConnect:
      return "connect";
    case Kind::kReplace:
      return "replace";
    case Kind::kStart:
      return "start";
    case Kind::kStartSuspended:
      return "start-suspended";
    case Kind::kEndProcess:
      return "end-process";
  }
  return "?";
}

std::string ToString(const PlanStep& step) {
  std::string text(ToString(step.kind));
  if (step.process.empty())
    return text + " " + ToString(step.wire.required) + " -> " + ToString(step.wire.provided);
  if (step.kind == Kind::kStartProcess) {
    return "start process " + step.process + " (restart " + std::string(ToString(step.restart)) +
           ")";
  }
  if (step.kind == Kind::kEndProcess) return "end process " + step.process;
  const std::string path = step.process + "/" + step.component.name;
  if (step.kind == Kind::kStartSuspended) return "start " + path + ", then suspend it";
  text += " " + path;
  return step.kind == Kind::kCreate ? text + Origin(step.component) : text;
}

}  // namespace tendon
