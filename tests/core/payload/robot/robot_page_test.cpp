#include <gtest/gtest.h>
#include <tendon/interface/function.h>
#include <tendon/manager/local_manager.h>
#include <tendon/payload/robot/joints.h>
#include <tendon/payload/robot/joystick.h>
#include <tendon/task/periodic_task.h>
#include <tests/support/wait.h>

/// The example of core/tendon/payload/robot/README.md.
namespace {

using namespace std::chrono_literals;

/// Holds its joints at a commanded position. Its commands have the names of CRTK.
class Wrist final : public tendon::PeriodicTask {
 public:
  explicit Wrist(std::string name) : PeriodicTask(std::move(name), 1ms) {
    joystick_.axes.resize(2);
    state_table().Add(joints_, "measured_js");
    state_table().Add(joystick_, "joystick", tendon::EncodedSize(joystick_));
    auto& arm = AddProvidedInterface("arm");
    arm.AddCommandReadState(state_table(), joints_, "measured_js");
    arm.AddCommandWrite(&Wrist::Servo, this, "servo_jp").SetHazard("motion");
  }

 private:
  void Run() override {
    ProcessQueuedCommands();
    joints_.position = goal_.position;
  }
  void Servo(const tendon::robot::JointCommand<3>& goal) { goal_ = goal; }

  tendon::robot::JointCommand<3> goal_;
  tendon::robot::JointState<3> joints_;
  tendon::robot::Joystick joystick_;
};

class Hand : public tendon::Component {
 public:
  explicit Hand(std::string name) : Component(std::move(name)) {
    auto& arm = AddRequiredInterface("arm");
    arm.AddFunction(measured_js, "measured_js");
    arm.AddFunction(servo_jp, "servo_jp");
  }

  tendon::ReadFunction<tendon::robot::JointState<3>> measured_js;
  tendon::WriteFunction<tendon::robot::JointCommand<3>> servo_jp;
};

TEST(RobotPage, ItsExampleExecutesCommandsAndReportsState) {
  tendon::LocalManager manager;
  auto& wrist = manager.Add<Wrist>("wrist");
  auto& hand = manager.Add<Hand>("hand");
  ASSERT_TRUE(manager.Connect({"hand", "arm"}, {"wrist", "arm"}));
  ASSERT_TRUE(manager.StartAll());
  const std::array<double, 3> goal{0.1, -0.2, 0.3};

  EXPECT_EQ(hand.servo_jp({.position = goal}), tendon::Status::kQueued);

  tendon::robot::JointState<3> joints;
  EXPECT_TRUE(EventuallyTrue([&] { return hand.measured_js(joints) && joints.position == goal; }));
  EXPECT_EQ(wrist.tables().front()->Find("joystick")->absent(), 0U);
}

}  // namespace
