#pragma once

#include <support/wait.h>
#include <tendon/gcm/catalogue.h>

#include <array>
#include <string>

namespace tendon::test {

using Joints = std::array<double, 7>;

/// The two interfaces of a connection.
const InterfaceName kRobot("desk", "teleoperation", "Robot");
const InterfaceName kControl("robot", "arm", "Control");

/// An interface with commands to read and to move the joints. It is compatible with Robot() below.
inline ProvidedDescription Control() {
  return {.name = "Control",
          .commands = {{.name = "GetJoints",
                        .signature = SignatureOf<None, Joints>(CommandKind::kRead),
                        .out_type = "float64[7]"},
                       {.name = "MoveTo",
                        .signature = SignatureOf<Joints, None>(CommandKind::kWrite),
                        .in_type = "float64[7]"},
                       {.name = "Scale",
                        .signature = SignatureOf<double, Joints>(CommandKind::kQualifiedRead),
                        .in_type = "float64",
                        .out_type = "float64[7]"},
                       {.name = "Stop", .signature = SignatureOf<None, None>(CommandKind::kVoid)}},
          .events = {}};
}

inline RequiredDescription Robot(const std::string& name = "Robot") {
  return {.name = name,
          .functions = {{.name = "GetJoints",
                         .signature = SignatureOf<None, Joints>(CommandKind::kRead),
                         .out_type = "float64[7]"},
                        {.name = "MoveTo",
                         .signature = SignatureOf<Joints, None>(CommandKind::kWrite),
                         .in_type = "float64[7]"}}};
}

inline ComponentDescription Arm(const std::string& name = "arm") {
  return {.name = name,
          .class_name = "SimulatedArm",
          .library = "simulated_arm",
          .state = ComponentState::kActive,
          .period = 0.001,
          .provided = {Control()},
          .tables = {{.name = "state",
                      .length = 1000,
                      .columns = {{"Joints", "float64[7]", FingerprintOf<Joints>()}}}}};
}

inline ComponentDescription Teleoperation(const std::string& name = "teleoperation") {
  return {.name = name,
          .class_name = "Teleoperation",
          .state = ComponentState::kActive,
          .required = {Robot()}};
}

/// A component with a suitable name, but with another interface.
inline ComponentDescription FakeArm() {
  ComponentDescription fake = Arm("fake");
  fake.class_name = "FakeArm";
  fake.provided[0].commands.erase(fake.provided[0].commands.begin() + 1);
  return fake;
}

/// Returns a goal in this unit. No program was built with this type.
inline Schema GoalIn(const std::string& unit) {
  return Schema::Structure("test.Goal", {{"position", unit, Schema(Schema::Kind::kFloat64)}});
}

inline MemberDescription MoveToGoal(const Schema& goal) {
  return {.name = "MoveTo",
          .signature = {CommandKind::kWrite, goal.fingerprint(), FingerprintOf<None>()},
          .in_type = goal.name()};
}

/// Returns a component with a command that takes this goal. Leader() returns a component that needs
/// this command.
inline ComponentDescription Mover(const Schema& goal) {
  return {.name = "mover", .provided = {{.name = "Control", .commands = {MoveToGoal(goal)}}}};
}
inline ComponentDescription Leader(const Schema& goal) {
  return {.name = "leader", .required = {{.name = "Mover", .functions = {MoveToGoal(goal)}}}};
}

inline ProcessDescription ProcessNamed(const std::string& name, std::uint64_t instance) {
  return {.name = name,
          .instance = instance,
          .host = "bench",
          .pid = static_cast<std::int64_t>(1000 + instance),
          .address = "127.0.0.1:" + std::to_string(20000 + instance % 10000)};
}

}  // namespace tendon::test
