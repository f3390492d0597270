#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gmock/gmock.h>

#include <QTest>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>

#include "live/live_window.h"
#include "support/machine/stall_meter.h"

namespace tendon::gui {
namespace {

constexpr int kArms = 8;
constexpr int kSignals = 100;
constexpr int kOfAnArm = 14;  // positions and velocities of seven joints

/// In s: some by default; TENDON_SOAK_SECONDS=60 for a minute, 600 for ten.
int Seconds() {
  constexpr int kDefault = 8;
  const int asked = qEnvironmentVariableIntValue("TENDON_SOAK_SECONDS");
  return asked > 0 ? asked : kDefault;
}

/// Ours, as "7.4 MB".
double MemoryInMegabytes() {
  std::ifstream lines("/proc/self/status");
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024;
  }
  return 0;
}

QString SignalOf(int number) {
  const int joint = number % kOfAnArm;
  return QString("many/arm%1/state.Joints.%2[%3]")
      .arg(number / kOfAnArm)
      .arg(joint < 7 ? "position" : "velocity")
      .arg(joint % 7);
}

class HundredSignalsTest : public LiveWindow {
 protected:
  std::string SystemOfArms() const {
    const std::string file = home.path() / "many.json";
    std::ofstream out(file);
    out << R"({"version": 1, "name": "many", "processes": [{"name": "many", "components": [)";
    for (int i = 0; i < kArms; ++i) {
      out << (i > 0 ? "," : "") << R"({"name": "arm)" << i
          << R"(", "class": "SimulatedArm", "library": "simulated_arm"})";
    }
    out << "]}]}";
    return file;
  }
};

TEST_F(HundredSignalsTest, EachRowOfAHundredSignalsAt1kHzArrives) {
  StartGcm();
  const auto many = StartLcm("many", SystemOfArms());
  ASSERT_NO_FATAL_FAILURE(Open(QString("many/arm%1/state.Joints").arg(kArms - 1)));
  PlotPanel& plots = *window().findChild<PlotPanel*>("plotPanel");
  const test::StallMeter stalls;
  for (int i = 0; i < kSignals; ++i) {
    if (i > 0 && i % 10 == 0) plots.addPlot();
    plots.addSignal(SignalOf(i), i % kOfAnArm < 7 ? "rad" : "rad/s");
  }
  const auto ringOf = [&](int i) -> const SampleRing& {
    return plots.plot(i / 10).curve(SignalOf(i))->samples();
  };
  const auto rows = static_cast<std::uint64_t>(Seconds()) * 1000;
  const int patience = kLivePatience + Seconds() * 10'000;
  for (int i = 0; i < kSignals; ++i) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return ringOf(i).endIndex() >= rows; }, patience))
        << SignalOf(i).toStdString() << ": " << ringOf(i).endIndex();
  }

  std::uint64_t received = 0;
  std::uint64_t lost = 0;
  for (int i = 0; i < kSignals; ++i) {
    const SampleRing& ring = ringOf(i);
    ASSERT_EQ(ring.firstIndex(), 0U);
    const std::uint64_t written = ring.tick(ring.endIndex() - 1) - ring.tick(0) + 1;
    EXPECT_EQ(ring.endIndex() + ring.lost(), written) << SignalOf(i).toStdString();
    EXPECT_EQ(ring.repeated(), 0U);
    received += ring.endIndex();
    lost += ring.lost();
  }
  std::printf(
      "  %llu rows of %d signals, %llu lost; %.0f MB in use; the machine stood still for "
      "%lld ms at most\n",
      static_cast<unsigned long long>(received), kSignals, static_cast<unsigned long long>(lost),
      MemoryInMegabytes(), static_cast<long long>(stalls.longest().count()));
  RecordProperty("lost", std::to_string(lost));
  // The rings of the LCM hold what a quarter of a second brings.
  constexpr std::chrono::milliseconds kStandstill{100};
  if (stalls.longest() < kStandstill) {
    EXPECT_EQ(lost, 0U);
  }
}

}  // namespace
}  // namespace tendon::gui
