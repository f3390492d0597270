#include <components/host_monitor/host_monitor.h>
#include <gtest/gtest.h>
#include <support/wait.h>
#include <tendon/manager/local_manager.h>

#include <filesystem>

#include "components/host_monitor/fake_host.h"
#include "components/stepped.h"

namespace host {
namespace {

using tendon_test::FakeHost;
using tendon_test::Stepped;

TEST(HostMonitor, RecordsValuesFromTheSystemFiles) {
  FakeHost host;
  host.Write("proc/stat", "cpu 10 0 10 80\ncpu0 10 0 10 80\n");
  host.Write("proc/meminfo", "MemTotal: 2097152 kB\nMemAvailable: 1048576 kB\n");
  host.Write("sys/class/thermal/thermal_zone0/type", "board\n");
  host.Write("sys/class/thermal/thermal_zone0/temp", "36600\n");
  tendon::LocalManager manager;
  auto& monitor = manager.Add<Stepped<HostMonitor>>("host_monitor", host.root());

  monitor.Cycle();
  host.Write("proc/stat", "cpu 40 0 10 150\ncpu0 40 0 10 150\n");
  monitor.Cycle();

  EXPECT_DOUBLE_EQ(monitor.Read<Cpu>("Cpu").total, 30.0);
  EXPECT_EQ(monitor.Read<Cpu>("Cpu").cores, std::vector<double>{30.0});
  EXPECT_EQ(monitor.Read<Memory>("Memory").used, 1024.0);
  EXPECT_EQ(monitor.Read<Memory>("Memory").total, 2048.0);
  const auto temperatures = monitor.Read<Temperatures>("Temperatures");
  ASSERT_EQ(temperatures.sensors.size(), 1U);
  EXPECT_EQ(temperatures.sensors[0].sensor, "board");
  EXPECT_EQ(temperatures.sensors[0].value, 36.6);
}

TEST(HostMonitor, RecordsZerosWithoutSystemFiles) {
  const FakeHost host;
  tendon::LocalManager manager;
  auto& monitor = manager.Add<Stepped<HostMonitor>>("host_monitor", host.root());

  EXPECT_TRUE(monitor.Cycle(3));

  EXPECT_EQ(monitor.Read<Cpu>("Cpu").total, 0.0);
  EXPECT_TRUE(monitor.Read<Cpu>("Cpu").cores.empty());
  EXPECT_EQ(monitor.Read<Memory>("Memory").total, 0.0);
  EXPECT_EQ(monitor.Read<Network>("Network").received, 0.0);
  EXPECT_EQ(monitor.tables().front()->Find("Temperatures"), nullptr);
}

TEST(HostMonitor, IgnoresCoresThatAppearLater) {
  FakeHost host;
  host.Write("proc/stat", "cpu 1 0 0 1\ncpu0 1 0 0 1\n");
  tendon::LocalManager manager;
  auto& monitor = manager.Add<Stepped<HostMonitor>>("host_monitor", host.root());

  host.Write("proc/stat", "cpu 1 0 0 1\ncpu0 1 0 0 1\ncpu1 1 0 0 1\ncpu2 1 0 0 1\n");
  monitor.Cycle();

  EXPECT_EQ(monitor.Read<Cpu>("Cpu").cores.size(), 1U);
  EXPECT_EQ(monitor.tables().front()->Find("Cpu")->absent(), 0U);
}

TEST(HostMonitor, ReadsTheRealMachine) {
  if (!std::filesystem::exists("/proc/stat")) GTEST_SKIP() << "no Linux";
  tendon::LocalManager manager;
  auto& monitor = manager.Add<HostMonitor>("host_monitor");
  const auto& cpu =
      dynamic_cast<const tendon::Column<Cpu>&>(*monitor.tables().front()->Find("Cpu"));
  const auto& memory =
      dynamic_cast<const tendon::Column<Memory>&>(*monitor.tables().front()->Find("Memory"));
  ASSERT_TRUE(manager.StartAll());

  Cpu load;
  EXPECT_TRUE(EventuallyTrue([&] { return cpu.ReadNewest(load) && load.total > 0.0; }));
  EXPECT_LE(load.total, 100.0);
  EXPECT_GE(load.cores.size(), 1U);
  Memory now;
  EXPECT_TRUE(memory.ReadNewest(now));
  EXPECT_GT(now.used, 1.0);
  EXPECT_LT(now.used, now.total);
}

}  // namespace
}  // namespace host
