#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "gcm_console/system_fixture.h"

/// The demo system, complete: `desk/supervisor/Robot` is connected to `robot/arm/Control`.
class DemoFixture : public SystemFixture {
 protected:
  void SetUp() override {
    StartGcm();
    robot = StartLcm("robot", demo);
    desk = StartLcm("desk", demo);
    ASSERT_TRUE(EventuallySays({"ls", "robot"}, "arm\tactive")) << robot->err();
    ASSERT_TRUE(EventuallySays({"ls", "desk"}, "teleoperation\tactive")) << desk->err();
    ASSERT_TRUE(EventuallySays({"get", "robot/arm/state.Joints"}, "position"));  // its first cycle
    ASSERT_TRUE(EventuallySays({"ls", "desk/supervisor"}, "-> robot/arm/Control\n"));
  }

  std::unique_ptr<Program> robot;
  std::unique_ptr<Program> desk;
};
