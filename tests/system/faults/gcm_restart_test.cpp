#include <algorithm>
#include <csignal>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "system/faults/harness/fault_test.h"

namespace faults {
namespace {

class GcmRestart : public FaultTest {
 protected:
  void KillGcm() const {
    gcm_->Signal(SIGKILL);
    gcm_->Wait();
  }
  [[nodiscard]] tendon::Fingerprint Hash() const { return viewer_->catalogue().ContentHash(); }
};

INSTANTIATE_TEST_SUITE_P(Over, GcmRestart, testing::ValuesIn(Middlewares()), NameOfMiddleware);

TEST_P(GcmRestart, RepeatedKillsUnderLoadLoseNothing) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  const tendon::Fingerprint before = Hash();
  const std::size_t unconnected = Lines("given", "not connected");
  const int rounds = Starts(GetParam() == Middlewares().front() ? 20 : 5, 100);
  std::vector<long> times;  // ms

  for (int round = 1; round <= rounds; ++round) {
    SCOPED_TRACE(round);
    const std::size_t snapshots = watch_->snapshots();
    KillGcm();
    ASSERT_TRUE(Flows(20)) << "without a GCM";
    const Stopwatch since_start;
    ASSERT_NO_FATAL_FAILURE(StartGcm());
    ASSERT_TRUE(Eventually([&] { return watch_->snapshots() > snapshots && Hash() == before; }));
    times.push_back(since_start.milliseconds());
  }

  ASSERT_TRUE(Flows());
  std::sort(times.begin(), times.end());
  Tell(std::to_string(rounds) + " kills; the catalogue was the same each time, after a median of " +
       std::to_string(times[times.size() / 2]) + " ms and " + std::to_string(times.back()) +
       " ms at most");
  ExpectNoRowLost();
  if (!MayExpireLeases()) {
    EXPECT_EQ(Lines("given", "not connected"), unconnected);
  }
  ExpectHonestCommands();
}

TEST_P(GcmRestart, ALongAbsenceLogsFewLines) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  const tendon::Fingerprint before = Hash();
  const std::size_t snapshots = watch_->snapshots();
  // A machine that stalls also logs that connections are lost and restored.
  const auto lines = [this] {
    int count = 0;
    std::istringstream log(robot_->err());
    for (std::string line; std::getline(log, line);) {
      if (line.find(" GCM at ") != std::string::npos) ++count;
    }
    return count;
  };
  const auto lines_before = lines();

  KillGcm();
  ASSERT_TRUE(Eventually([&] { return lines() > lines_before; })) << robot_->err();
  const int seconds = Size(3, 600);
  std::this_thread::sleep_for(std::chrono::seconds(seconds));
  const auto lines_of_absence = lines() - lines_before;
  ASSERT_NO_FATAL_FAILURE(StartGcm());
  const Stopwatch since_start;
  ASSERT_TRUE(Eventually([&] { return watch_->snapshots() > snapshots && Hash() == before; }));

  Tell("after " + std::to_string(seconds) + " s without a GCM, complete again within " +
       std::to_string(since_start.milliseconds()) + " ms");
  EXPECT_LE(lines_of_absence, 2 + seconds / 10) << robot_->err();
  ASSERT_TRUE(Flows());
  ExpectNoRowLost();
  ExpectHonestCommands();
}

TEST_P(GcmRestart, ManyLcmsRejoinWithoutLosses) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  const int count = Starts(12, 100);
  std::vector<std::unique_ptr<Program>> herd;
  for (int i = 0; i < count; ++i) {
    const std::string name = "sheep" + std::to_string(i);
    herd.push_back(std::make_unique<Program>(Command("lcm", {"--name", name}), environment()));
  }
  const auto is_complete = [&] {
    const auto catalogue = viewer_->catalogue();
    const auto& all = catalogue.processes();
    const bool all_alive = std::all_of(all.begin(), all.end(), [](const auto& one) {
      return one.second.process.state == tendon::ProcessState::kAlive;
    });
    return all_alive && all.size() == herd.size() + 2;
  };
  const auto words = [&herd] {
    std::string all;
    for (const auto& sheep : herd) all += sheep->err();
    return all;
  };
  ASSERT_TRUE(Eventually(is_complete)) << words();
  const tendon::Fingerprint before = Hash();

  const std::size_t snapshots = watch_->snapshots();
  KillGcm();
  const Stopwatch since_death;
  ASSERT_NO_FATAL_FAILURE(StartGcm());
  ASSERT_TRUE(Eventually([&] { return watch_->snapshots() > snapshots && is_complete(); }))
      << words();

  Tell(std::to_string(count + 2) + " LCMs were back " + std::to_string(since_death.milliseconds()) +
       " ms after the GCM was killed");
  EXPECT_TRUE(Eventually([&] { return Hash() == before; }));
  ASSERT_TRUE(Flows());
  for (int i = 0; i < count; ++i) {
    ExpectNeverLost("sheep" + std::to_string(i));
  }
  ExpectNoRowLost();
}

}  // namespace
}  // namespace faults
