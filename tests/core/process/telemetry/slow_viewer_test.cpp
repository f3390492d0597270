#include <tendon/task/periodic_task.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>

#include "conformance/resources.h"
#include "core/process/telemetry/viewing.h"
#include "support/wait.h"

namespace {

using namespace std::chrono_literals;
using tendon::SteadyTime;
namespace conformance = tendon::conformance;

/// Writes twenty rows of 264 bytes per millisecond, up to the allowed number.
class Spate final : public tendon::PeriodicTask {
 public:
  static constexpr std::uint64_t kRate = 20'000;

  explicit Spate(std::string name) : PeriodicTask(std::move(name), 1ms) {
    state_table().Add(values_, "Values");
    state_table().SetLength(1U << 15U);
    state_table().AdvanceOnlyByHand();
  }
  ~Spate() override { Join(); }

  void Run() override {
    for (int row = 0; row < 20 && written() < most_.load(); ++row) {
      ++values_.front();
      state_table().Advance(tendon::SteadyClock().Now());
    }
  }

  /// Sets the total number of rows that it may write.
  void Allow(std::uint64_t rows) { most_ = rows; }
  [[nodiscard]] std::uint64_t written() { return state_table().next_tick(); }

 private:
  std::array<double, 32> values_{};
  std::atomic<std::uint64_t> most_{0};
};

/// Counts its rows, and can block the thread that delivers them.
class Counter final : public tendon::RowSink {
 public:
  void OnSubscribed(const std::vector<tendon::Schema>& /*columns*/) override { stands_ = true; }
  void OnRows(const tendon::RowBatch& batch) override {
    received_ += batch.count;
    lost_in_table_ += batch.lost.table;
    lost_on_network_ += batch.lost.network;
    const std::scoped_lock held(gate);
  }
  void OnStale(const tendon::Error& /*reason*/) override {}

  [[nodiscard]] bool stands() const { return stands_.load(); }
  [[nodiscard]] std::uint64_t received() const { return received_.load(); }
  [[nodiscard]] std::uint64_t lost_in_table() const { return lost_in_table_.load(); }
  [[nodiscard]] std::uint64_t lost_on_network() const { return lost_on_network_.load(); }

  std::mutex gate;

 private:
  std::atomic<bool> stands_{false};
  std::atomic<std::uint64_t> received_{0};
  std::atomic<std::uint64_t> lost_in_table_{0};
  std::atomic<std::uint64_t> lost_on_network_{0};
};

/// Several viewers of a process; the slowest one is stopped.
class SlowViewer : public ViewingTest {
 protected:
  struct Viewer {
    std::unique_ptr<tendon::TelemetryClient> client;
    std::shared_ptr<Counter> sink = std::make_shared<Counter>();
  };

  SlowViewer() : robot(Start("robot")), spate(&robot->Add<Spate>("spate")) {
    EXPECT_TRUE(robot->StartAll().ok());
  }

  Viewer Watch() {
    Viewer viewer{.client = View()};
    viewer.client->Subscribe({"robot", "spate", "state", {"Values"}}, viewer.sink);
    EXPECT_TRUE(EventuallyTrue([&] { return viewer.sink->stands(); }));
    return viewer;
  }

  /// Writes further rows. The source waits for the quick viewers, so the speed of this machine does
  /// not matter.
  void Write(std::uint64_t rows, const std::vector<const Viewer*>& quick) {
    constexpr std::uint64_t kAhead = 10'000;  // less than the table and the link hold
    const std::uint64_t end = spate->written() + rows;
    const auto all_taken = [&] {
      std::uint64_t taken = end;
      for (const Viewer* viewer : quick) taken = std::min(taken, viewer->sink->received());
      spate->Allow(std::min(end, taken + kAhead));
      return taken == end;
    };
    ASSERT_TRUE(EventuallyTrue(all_taken, 10min));
  }

  /// Prints the speed of this machine. Does not check it.
  static void Tell(std::uint64_t rows, std::chrono::duration<double> took) {
    std::printf("%.0f rows a second to each viewer\n", static_cast<double>(rows) / took.count());
  }

  std::unique_ptr<tendon::Process> robot;
  Spate* spate;
};

TEST_P(SlowViewer, LosesOnlyItsOwnRowsAndCountsThem) {
  const std::uint64_t seconds = std::getenv("TENDON_FULL_FAULTS") == nullptr ? 5 : 60;
  const Viewer first = Watch();
  const Viewer stopped = Watch();
  const Viewer second = Watch();
  Write(Spate::kRate / 10, {&first, &stopped, &second});

  // The rows for the stopped viewer soon fill its link. It misses all later rows.
  std::size_t memory = 0;
  std::size_t growth = 0;
  {
    const std::scoped_lock held(stopped.sink->gate);
    Write(Spate::kRate, {&first, &second});
    memory = conformance::MemoryInUse();
    const SteadyTime begin = tendon::SteadyClock().Now();
    Write(seconds * Spate::kRate, {&first, &second});
    Tell(seconds * Spate::kRate, tendon::SteadyClock().Now() - begin);
    const std::size_t now = conformance::MemoryInUse();
    growth = now - std::min(memory, now);
  }
  EXPECT_LT(growth, std::size_t{16} << 20U) << "of " << memory << " bytes";
  Write(Spate::kRate / 10, {&first, &second});

  // The next batch reports the loss.
  const Counter& late = *stopped.sink;
  EXPECT_TRUE(EventuallyTrue([&] {
    Write(1, {&first, &second});
    return late.received() + late.lost_on_network() == spate->written();
  })) << late.received()
      << " + " << late.lost_on_network() << " of " << spate->written();
  EXPECT_GT(late.lost_on_network(), 0U);
  EXPECT_EQ(late.lost_in_table(), 0U);
  const std::uint64_t sent = spate->written();
  for (const Viewer* quick : {&first, &second}) {
    EXPECT_EQ(quick->sink->received(), sent);
    EXPECT_EQ(quick->sink->lost_in_table() + quick->sink->lost_on_network(), 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(Over, SlowViewer, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
