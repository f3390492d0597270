#pragma once

#include <tendon/interface/connection.h>

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tendon_test {

struct JointGoal {
  std::array<double, 7> position{};

  bool operator==(const JointGoal&) const = default;
};

/// Has the same fields as JointGoal and the same name, but another layout in memory. A type of
/// another plug-in may differ in this way.
struct PaddedJointGoal {
  double padding = 0.0;
  std::array<double, 7> position{};
};

/// A type whose values vary in size.
struct Message {
  std::string text;
  std::vector<double> numbers;
};

/// JointGoal in another unit.
struct JointGoalInDegrees {
  std::array<double, 7> position{};
};

}  // namespace tendon_test

template <>
inline constexpr auto tendon::kPayload<tendon_test::JointGoal> = tendon::Describe(
    "test.JointGoal", tendon::Field{"position", &tendon_test::JointGoal::position, "rad"});
template <>
inline constexpr auto tendon::kPayload<tendon_test::PaddedJointGoal> = tendon::Describe(
    "test.JointGoal", tendon::Field{"position", &tendon_test::PaddedJointGoal::position, "rad"});
template <>
inline constexpr auto tendon::kPayload<tendon_test::Message> =
    tendon::Describe("test.Message", tendon::Field{"text", &tendon_test::Message::text},
                     tendon::Field{"numbers", &tendon_test::Message::numbers});
template <>
inline constexpr auto tendon::kPayload<tendon_test::JointGoalInDegrees> = tendon::Describe(
    "test.JointGoal", tendon::Field{"position", &tendon_test::JointGoalInDegrees::position, "deg"});

namespace tendon_test {

/// A server without a thread: the test executes its inbox.
struct Arm {
  tendon::Inbox inbox;
  tendon::StateTable table;
  JointGoal joints;
  tendon::ProvidedInterface control{"Control", &inbox};
  tendon::WriteEvent<std::int32_t> limit_exceeded;
  tendon::VoidEvent stopped;

  std::vector<JointGoal> moves;
  std::vector<std::string> texts;
  int stops = 0;

  Arm() {
    table.SetLength(8);
    table.Add(joints, "Joints");
    control.AddCommandVoid(&Arm::Stop, this, "Stop");
    control.AddCommandWrite(&Arm::MoveTo, this, "MoveTo");
    control.AddCommandWrite(&Arm::Say, this, "Say");
    control.AddCommandReadState(table, joints, "GetJoints");
    control.AddCommandQualifiedRead(table, joints, &Arm::JointAt, "GetJoint");
    control.AddEvent(limit_exceeded, "LimitExceeded");
    control.AddEvent(stopped, "Stopped");
    inbox.SetAccepting(true);
  }

  void Stop() { ++stops; }
  void MoveTo(const JointGoal& goal) { moves.push_back(goal); }
  void Say(const Message& message) { texts.push_back(message.text); }
  static void JointAt(const JointGoal& row, const std::int32_t& joint, double& position) {
    position = row.position.at(static_cast<std::size_t>(joint));
  }
  void Advance() { table.Advance(tendon::SteadyClock().Now()); }
};

/// A client without a thread.
struct Teleoperation {
  tendon::Inbox inbox;
  tendon::RequiredInterface robot{"Robot", &inbox};
  tendon::VoidFunction stop;
  tendon::WriteFunction<JointGoal> move_to;
  tendon::WriteFunction<Message> say;
  tendon::ReadFunction<JointGoal> get_joints;
  tendon::QualifiedReadFunction<std::int32_t, double> get_joint;
  tendon::VoidFunction wave;

  std::vector<std::int32_t> limits;
  int stops_seen = 0;

  Teleoperation() {
    robot.AddFunction(stop, "Stop");
    robot.AddFunction(move_to, "MoveTo");
    robot.AddFunction(say, "Say");
    robot.AddFunction(get_joints, "GetJoints");
    robot.AddFunction(get_joint, "GetJoint");
    robot.AddFunction(wave, "Wave", tendon::Need::kOptional);
    robot.AddEventHandlerWrite(&Teleoperation::OnLimit, this, "LimitExceeded");
    robot.AddEventHandlerVoid(&Teleoperation::OnStopped, this, "Stopped");
    inbox.SetAccepting(true);
  }

  void OnLimit(std::int32_t joint) { limits.push_back(joint); }
  void OnStopped() { ++stops_seen; }
};

/// Connects two compatible interfaces.
inline std::unique_ptr<tendon::Connection> ConnectionOf(tendon::RequiredInterface& required,
                                                        tendon::ProvidedInterface& provided) {
  return std::move(*tendon::Connection::Make(required, provided, "client/" + required.name(),
                                             "server/" + provided.name()));
}

inline auto Connect(Teleoperation& client, Arm& server) {
  return tendon::Connection::Make(client.robot, server.control, "teleoperation/Robot",
                                  "arm/Control");
}

}  // namespace tendon_test
