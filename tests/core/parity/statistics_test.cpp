#include <tendon/task/cycle_statistics.h>

#include "core/parity/pair.h"

namespace tendon_test {
namespace {

using tendon::CycleStatistics;
using tendon::CycleSummary;
using tendon::Status;
using tendon::TimeStatistics;

/// Reads the statistics of a server through its interface `state`, like any client.
class Observer final : public tendon::Component {
 public:
  explicit Observer(std::string name) : Component(std::move(name)) {
    auto& state = AddRequiredInterface("State");
    state.AddFunction(cycle, "Cycle");
    state.AddFunction(summary, "CycleSummary");
  }
  tendon::ReadFunction<CycleStatistics> cycle;
  tendon::ReadFunction<CycleSummary> summary;
};

void ExpectOrdered(const TimeStatistics& time) {
  EXPECT_LE(time.min, time.mean);
  EXPECT_LE(time.mean, time.max);
  EXPECT_LE(time.min, time.max);
  EXPECT_LE(time.p50, time.p99);
  EXPECT_GE(time.deviation, 0.0);
  EXPECT_LE(time.deviation, time.max - time.min);
}

/// The statistics of every kind of task.
using Statistics = AnyServer;

TEST_P(Statistics, AreColumnsOfTheTasksTable) {
  auto& observer = pair.manager.Add<Observer>("observer");
  ASSERT_TRUE(pair.manager.Connect({"observer", "State"}, {"server", "state"}).ok());
  CycleStatistics cycle;
  ASSERT_TRUE(EventuallyTrue([&] {
    pair.OnceInServer([] {});
    return observer.cycle(cycle) == Status::kDone && cycle.period > 0.0 && cycle.compute > 0.0;
  }));

  EXPECT_GE(cycle.lateness, 0.0);
  const double wanted = pair.server.component().period();
  if (wanted > 0.0) {
    EXPECT_DOUBLE_EQ(cycle.load, cycle.compute / wanted);
  } else {
    EXPECT_EQ(cycle.load, 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Parity, Statistics, testing::ValuesIn(TaskKinds()), NameOfKind);

TEST(CycleSummaries, CoverEveryKindOfTask) {
  std::vector<std::unique_ptr<Pair>> pairs;
  std::vector<Observer*> observers;
  for (const Kind kind : TaskKinds()) {
    pairs.push_back(std::make_unique<Pair>(Kind::kThreadless, kind));
    observers.push_back(&pairs.back()->manager.Add<Observer>("observer"));
    ASSERT_TRUE(pairs.back()->manager.Connect({"observer", "State"}, {"server", "state"}).ok());
  }

  CycleSummary summary;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_TRUE(EventuallyTrue([&] {
      for (const auto& pair : pairs) pair->OnceInServer([] {});
      return observers[i]->summary(summary) == Status::kDone && summary.cycles >= 10;
    })) << NameOf(TaskKinds()[i]);
    ExpectOrdered(summary.period);
    ExpectOrdered(summary.lateness);
    ExpectOrdered(summary.compute);
    EXPECT_GT(summary.period.mean, 0.0);
    EXPECT_GT(summary.compute.mean, 0.0);
  }
}

}  // namespace
}  // namespace tendon_test
