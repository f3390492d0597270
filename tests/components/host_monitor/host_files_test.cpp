#include <components/host_monitor/host_files.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "components/host_monitor/fake_host.h"

namespace host {
namespace {

using tendon_test::FakeHost;

std::vector<std::string> Names(const Temperatures& temperatures) {
  std::vector<std::string> names;
  for (const Temperature& one : temperatures.sensors) names.push_back(one.sensor);
  return names;
}

TEST(ReadText, AMissingFileIsEmpty) { EXPECT_EQ(ReadText("/nowhere/at/all"), ""); }

TEST(Thermometers, AreEmptyWithoutSensors) {
  const FakeHost host;

  EXPECT_TRUE(Thermometers(host.root()).empty());
}

TEST(Thermometers, AreFoundInZonesAndChipsByTheirNames) {
  FakeHost host;
  host.Write("sys/class/thermal/thermal_zone0/type", "x86_pkg_temp\n");
  host.Write("sys/class/thermal/thermal_zone0/temp", "41000\n");
  host.Write("sys/class/thermal/cooling_device0/type", "Fan\n");
  host.Write("sys/class/hwmon/hwmon0/name", "coretemp\n");
  host.Write("sys/class/hwmon/hwmon0/temp1_input", "39000\n");
  host.Write("sys/class/hwmon/hwmon0/temp1_label", "Core 0\n");
  host.Write("sys/class/hwmon/hwmon0/temp1_max", "100000\n");
  host.Write("sys/class/hwmon/hwmon0/temp2_input", "38500\n");
  host.Write("sys/class/hwmon/hwmon0/fan1_input", "1200\n");

  const Thermometers thermometers(host.root());
  Temperatures temperatures;
  thermometers.Read(temperatures);

  EXPECT_EQ(Names(temperatures),
            (std::vector<std::string>{"x86_pkg_temp", "coretemp Core 0", "coretemp temp2"}));
  EXPECT_EQ(temperatures.sensors[0].value, 41.0);
  EXPECT_EQ(temperatures.sensors[2].value, 38.5);
}

TEST(Thermometers, SkipSensorsWithoutATemperature) {
  FakeHost host;
  host.Write("sys/class/thermal/thermal_zone0/type", "broken\n");
  host.Write("sys/class/thermal/thermal_zone0/temp", "-274000\n");
  host.Write("sys/class/thermal/thermal_zone1/type", "without\n");

  EXPECT_TRUE(Thermometers(host.root()).empty());
}

TEST(Thermometers, ARemovedSensorReadsNanAndKeepsItsPlace) {
  FakeHost host;
  host.Write("sys/class/thermal/thermal_zone0/temp", "41000\n");
  host.Write("sys/class/thermal/thermal_zone1/temp", "42000\n");
  const Thermometers thermometers(host.root());
  host.Remove("sys/class/thermal/thermal_zone0/temp");

  Temperatures temperatures;
  thermometers.Read(temperatures);

  EXPECT_EQ(Names(temperatures), (std::vector<std::string>{"thermal_zone0", "thermal_zone1"}));
  EXPECT_TRUE(std::isnan(temperatures.sensors[0].value));
  EXPECT_EQ(temperatures.sensors[1].value, 42.0);
}

TEST(Thermometers, TruncateALongName) {
  FakeHost host;
  host.Write("sys/class/thermal/thermal_zone0/type", std::string(5000, 'x'));
  host.Write("sys/class/thermal/thermal_zone0/temp", "41000\n");

  Temperatures temperatures;
  Thermometers(host.root()).Read(temperatures);

  EXPECT_EQ(Names(temperatures), std::vector<std::string>{std::string(32, 'x')});
}

}  // namespace
}  // namespace host
