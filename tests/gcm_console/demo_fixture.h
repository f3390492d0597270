#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "gcm_console/system_fixture.h"

/// The demo system, complete and active: `desk/supervisor/Robot` is connected to
/// `robot/arm/Control`.
class DemoFixture : public SystemFixture {
 protected:
  void SetUp() override {
    StartGcm();
    robot = StartLcm("robot", demo);
    desk = StartLcm("desk", demo);
    // Host_monitor is the last component that starts.
    ASSERT_TRUE(EventuallySays({"ls", "robot"}, "host_monitor\tactive")) << robot->err();
    ASSERT_TRUE(EventuallySays({"ls", "desk"}, "old_arm\tactive")) << desk->err();
    // Waits for the first cycle of the arm.
    ASSERT_TRUE(EventuallySays({"get", "robot/arm/state.Joints"}, "position"));
    ASSERT_TRUE(EventuallySays({"ls", "desk/supervisor"}, "-> robot/arm/Control\n"));
  }

  std::unique_ptr<Program> robot;
  std::unique_ptr<Program> desk;
};
