#include "support/program.h"
#include "system/faults/harness/fault_test.h"
#include "system/faults/harness/islands.h"

namespace faults {
namespace {

/// The GCM and desk are on one island. robot, and mate as its client, are on the other island.
class BadLine : public FaultTest {
 protected:
  void SetUp() override {
    if (!islands_.ok()) GTEST_SKIP() << islands_.reason();
    // No other program uses this port on the island.
    gcm_address_ = std::string(Islands::kHere) + ":10705";
  }

  [[nodiscard]] std::unique_ptr<Program> Run(Words island, const std::string& program,
                                             const Words& words) const {
    const Words command = Command(program, words);
    island.insert(island.end(), command.begin(), command.end());
    return std::make_unique<Program>(island, environment());
  }
  [[nodiscard]] std::unique_ptr<Program> RunLcm(const Words& island, const std::string& address,
                                                const std::string& name) const {
    return Run(island, "lcm",
               {"--insecure", "--listen", address + ":0", "--name", name, "--system",
                home_.path() / "system.json"});
  }
  void ServeHere() {
    gcm_ = Run(islands_.Here(), "gcm", {"--insecure", "serve"});
    ASSERT_TRUE(Eventually([this] { return gcm_->out().starts_with("GCM at "); })) << gcm_->err();
  }
  /// Waits until the GCM lists the process in this state.
  [[nodiscard]] bool EventuallyListed(const std::string& process, const std::string& state) const {
    return Eventually([&] {
      const auto listing = Run(islands_.Here(), "gcm", {"--insecure", "ls"});
      listing->Wait();
      return listing->out().find(process + "\t" + state) != std::string::npos;
    });
  }

  const Islands islands_;
};

INSTANTIATE_TEST_SUITE_P(Over, BadLine, testing::ValuesIn(Middlewares()), NameOfMiddleware);

TEST_P(BadLine, BothSidesWorkDuringACutAndReconnect) {
  ASSERT_NO_FATAL_FAILURE(ServeHere());
  robot_ = RunLcm(islands_.There(), Islands::kThere, "robot");
  auto mate = RunLcm(islands_.There(), Islands::kThere, "mate");
  desk_ = RunLcm(islands_.Here(), Islands::kHere, "desk");
  ASSERT_TRUE(EventuallyExecutesMore(2)) << robot_->err() << mate->err() << desk_->err();

  for (const auto cut :
       {Islands::Cut::kBothWays, Islands::Cut::kFromHere, Islands::Cut::kFromThere}) {
    SCOPED_TRACE(static_cast<int>(cut));
    islands_.Make(cut);
    const Stopwatch since_cut;
    ASSERT_TRUE(EventuallyListed("robot", "lost"));
    ASSERT_TRUE(EventuallyListed("mate", "lost"));
    const long lost_after = since_cut.milliseconds();
    EXPECT_TRUE(EventuallyListed("desk", "alive"));
    EXPECT_TRUE(EventuallyExecutesMore(1)) << "robot and mate are on the same island";
    islands_.Heal();
    const Stopwatch since_healed;
    ASSERT_TRUE(EventuallyListed("robot", "alive")) << robot_->err();
    ASSERT_TRUE(EventuallyListed("mate", "alive")) << mate->err();
    ASSERT_TRUE(EventuallyExecutesMore(2)) << desk_->err();
    Tell("cut " + std::to_string(static_cast<int>(cut)) + ": lost after " +
         std::to_string(lost_after) + " ms; together again " +
         std::to_string(since_healed.milliseconds()) + " ms after it healed");
  }

  mate.reset();
  ExpectHonestCommands();
}

/// All data from and to the robot goes over a slow line that loses some of it.
TEST_P(BadLine, ASlowLossyLineLosesNoProcess) {
  ASSERT_NO_FATAL_FAILURE(ServeHere());
  const std::string here = Islands::kHere;
  const auto run_proxy = [&](const std::string& port, const std::string& target) {
    Words command = islands_.Here();
    for (const std::string& word :
         {Built("tests/fault_lossy_proxy"), here + ":" + port, here + ":" + target}) {
      command.push_back(word);
    }
    return std::make_unique<Program>(command);
  };
  const auto to_gcm = run_proxy("10706", "10705");
  const auto to_robot = run_proxy("10801", "10800");
  ASSERT_TRUE(Eventually([&] { return to_gcm->out() + to_robot->out() == "ready\nready\n"; }))
      << to_gcm->err() << to_robot->err();
  gcm_address_ = here + ":10706";
  robot_ = Run(islands_.Here(), "lcm",
               {"--insecure", "--listen", here + ":10800", "--advertise", here + ":10801", "--name",
                "robot", "--system", home_.path() / "system.json"});
  desk_ = RunLcm(islands_.Here(), Islands::kHere, "desk");
  gcm_address_ = here + ":10705";
  ASSERT_TRUE(EventuallyExecutesMore()) << robot_->err() << desk_->err();

  const int seconds = Size(8, 600);
  std::this_thread::sleep_for(std::chrono::seconds(seconds));

  ASSERT_TRUE(EventuallyExecutesMore());
  const bool was_any_lost = (robot_->err() + desk_->err()).find("was lost") != std::string::npos;
  EXPECT_TRUE(MayExpireLeases() || !was_any_lost) << robot_->err() << desk_->err();
  Tell(std::to_string(seconds) + " s with 40 ms of delay and 5 % of loss: no false alarm");
  ExpectHonestCommands();
}

}  // namespace
}  // namespace faults
