#pragma once

#include <tendon/proxy/component_proxy.h>

#include <memory>
#include <string>

#include "support/network_test.h"
#include "support/plant.h"

inline const tendon::InterfaceName kRobot("desk", "operator", "Robot");
inline const tendon::InterfaceName kControl("robot", "plant", "Control");

/// Process robot with a running plant, and process desk with an operator.
class RemoteConnection : public NetworkTest {
 protected:
  void StartRobot() {
    robot = Start("robot");
    plant = &robot->Add<plant::Plant>("plant");
    ASSERT_TRUE(robot->StartAll().ok());
  }
  void StartDesk(std::size_t capacity = 64) {
    desk = Start("desk");
    user = &desk->Add<plant::Operator>("operator", capacity);
    ASSERT_TRUE(desk->StartAll().ok());
  }
  void Connect() {
    const auto id = desk->Connect(kRobot, kControl);
    ASSERT_TRUE(id.ok()) << id.error().message;
    ASSERT_TRUE(EventuallyActive(*desk, 1)) << Reason();
  }
  std::string Reason() const { return desk->connections().front().reason; }
  /// The number of connections that robot serves.
  std::size_t Served() const {
    std::size_t count = 0;
    for (const auto& proxy : robot->proxies()) count += proxy.required.size();
    return count;
  }
  template <typename Call>
  static bool EventuallyQueued(Call call) {
    return EventuallyTrue([&] { return call() == tendon::Status(tendon::Status::kQueued); });
  }

  std::unique_ptr<tendon::Process> robot;
  std::unique_ptr<tendon::Process> desk;
  plant::Plant* plant = nullptr;
  plant::Operator* user = nullptr;
};
