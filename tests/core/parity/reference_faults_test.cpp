#include <tendon/interface/connection.h>
#include <tendon/state/row_copy.h>
#include <tendon/task/callback_task.h>
#include <tendon/task/cycle_statistics.h>
#include <tendon/task/main_task.h>
#include <tendon/task/periodic_task.h>

#include <algorithm>
#include <filesystem>
#include <future>
#include <iterator>
#include <new>
#include <stdexcept>

#include "core/parity/pair.h"
#include "support/allocation_guard.h"
#include "support/log/log_record.h"

// Tests of the faults of cisst. The README of this folder names the tests of the other faults.

namespace tendon_test {
namespace {

using tendon::Connection;
using tendon::RowResult;
using tendon::Status;
using namespace std::chrono_literals;

TEST(ReferenceFault, AFullQueueIsCountedButNotLogged) {
  tendon::Inbox inbox;
  inbox.SetAccepting(true);
  tendon::ProvidedInterface provided("Pose", &inbox);
  tendon::StateTable table;
  ServerPort<Pose> server;
  server.AddTo(provided, table, "Pose");
  tendon::RequiredInterface required("Pose", nullptr);
  ClientPort<Pose> client;
  client.AddTo(required);
  const auto connection = Connection::Make(required, provided, "client/Pose", "server/Pose");
  ASSERT_TRUE(connection.ok()) << connection.error().message;
  const LogRecord log("server");

  {
    const tendon::AllocationGuard guard;
    for (int i = 0; i < 640; ++i) {
      EXPECT_EQ(client.reset(), i < 64 ? Status::kQueued : Status::kQueueFull) << i;
    }
  }

  EXPECT_EQ((*connection)->refused(), 576U);
  EXPECT_EQ((*connection)->waiting(), 64U);
  EXPECT_EQ(inbox.ExecuteQueued(), 64U);
  EXPECT_TRUE(log.texts().empty());
}

/// Adds a column to its table while it runs.
class Growing final : public tendon::CallbackTask {
 public:
  explicit Growing(std::string name) : CallbackTask(std::move(name)) {
    state_table().Add(count, "Count");
  }
  std::uint64_t count = 0;
  std::array<double, 100> late{};

 private:
  void Run() override {
    if (++count == 3) state_table().Add(late, "Late");
  }
};

TEST(ReferenceFault, ATableWithRowsIsNotGrownAndStaysIntact) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Growing>("task");
  ASSERT_TRUE(manager.StartAll().ok());
  EXPECT_TRUE(task.Cycle());
  EXPECT_TRUE(task.Cycle());

  EXPECT_FALSE(task.Cycle());

  EXPECT_EQ(task.fault(),
            "Run: cannot add column 'Late' to state table 'state' (sealed): add it in the "
            "constructor");
  const tendon::StateTable& table = *task.tables().front();
  std::uint64_t value = 0;
  EXPECT_EQ(table.Find("Late"), nullptr);
  EXPECT_EQ(table.Find(task.count).ReadAt(0, value), RowResult::kDone);
  EXPECT_EQ(value, 1U);
  EXPECT_EQ(table.Find(task.count).ReadNewest(value), Status::kDone);
  EXPECT_EQ(value, 2U);
}

/// Values that cannot be encoded: a text that is too long for its column, and an enumerator without
/// a name.
using Unserialisable = AnyPair;

TEST_P(Unserialisable, ValuesStopNoInterface) {
  pair.OnceInServer([&] {  // all in one cycle
    ForEachPort(pair.server.ports, [](auto& port) { Fill(port.goal, 3); });
    std::get<ServerPort<std::string>>(pair.server.ports).goal.assign(2 * kColumnCapacity, 'x');
    std::get<ServerPort<Pose>>(pair.server.ports).goal.frame = static_cast<Frame>(17);
    pair.server.Publish();
  });
  pair.OnceInClient([&] {
    std::string text;
    EXPECT_TRUE(EventuallyTrue([&] {
      Joints joints{};
      return std::get<ClientPort<Joints>>(pair.client.ports).read(joints) == Status::kDone &&
             IsSample(joints, 3);
    }));
    auto& texts = std::get<ClientPort<std::string>>(pair.client.ports);
    EXPECT_EQ(texts.read(text), Status::kNoSample);
    EXPECT_EQ(texts.write("still there"), pair.queued());
    Pose pose;
    auto& poses = std::get<ClientPort<Pose>>(pair.client.ports);
    EXPECT_EQ(poses.read(pose), Status::kInvalid);
    EXPECT_EQ(poses.reset(), pair.queued());
  });

  pair.InServer([](auto& port) { Fill(port.goal, 4); });
  pair.OnceInServer([&] { pair.server.Publish(); });
  pair.InClient([](auto& port) {
    PayloadIn<decltype(port)> value;
    EXPECT_TRUE(
        EventuallyTrue([&] { return port.read(value) == Status::kDone && IsSample(value, 4); }));
  });
  pair.OnceInServer([&] {
    EXPECT_EQ(std::get<ServerPort<std::string>>(pair.server.ports).received.size(), 1U);
    EXPECT_EQ(std::get<ServerPort<Pose>>(pair.server.ports).resets, 1);
  });
}

INSTANTIATE_TEST_SUITE_P(Parity, Unserialisable, AllPairs(), NameOfPair);

/// A command that cannot be bound, because its binding throws for lack of memory.
class Unbindable final : public tendon::Offer {
 public:
  Unbindable()
      : Offer(tendon::DescribeMember<tendon::None, tendon::None>("Last",
                                                                 tendon::CommandKind::kVoid)) {}
  [[nodiscard]] std::unique_ptr<tendon::CommandBase> Bind(tendon::Mailbox* /*box*/) const override {
    throw std::bad_alloc();
  }
};

TEST(ReferenceFault, AFailedConnectIsRolledBack) {
  tendon::Inbox server_inbox;
  tendon::Inbox client_inbox;
  server_inbox.SetAccepting(true);
  client_inbox.SetAccepting(true);
  tendon::ProvidedInterface provided("Pose", &server_inbox);
  tendon::StateTable table;
  ServerPort<Pose> server;
  server.AddTo(provided, table, "Pose");
  provided.AddOffer(std::make_unique<Unbindable>());
  tendon::RequiredInterface required("Pose", &client_inbox);
  ClientPort<Pose> client;
  client.AddTo(required);
  tendon::RequiredInterface demanding("Pose", &client_inbox);
  ClientPort<Pose> unlucky;
  unlucky.AddTo(demanding);
  tendon::VoidFunction last;
  demanding.AddFunction(last, "Last");

  EXPECT_THROW((void)Connection::Make(demanding, provided, "client/Pose", "server/Pose"),
               std::bad_alloc);

  EXPECT_FALSE(demanding.is_connected());
  EXPECT_EQ(unlucky.reset(), Status::kNotConnected);
  EXPECT_EQ(last(), Status::kNotConnected);
  Pose pose;
  EXPECT_EQ(unlucky.settled.Wait(pose, 0ns), Status::kNotConnected);
  server.done();
  server.passed(pose);
  EXPECT_EQ(client_inbox.ExecuteQueued(), 0U);
  EXPECT_TRUE(unlucky.passed.empty());
  EXPECT_EQ(server.done.lost() + server.passed.lost(), 0U);
  EXPECT_TRUE(Connection::Make(required, provided, "client/Pose", "server/Pose").ok());
}

/// A client that continues to call while it is disconnected.
using DisconnectUnderLoad = AnyPair;

TEST_P(DisconnectUnderLoad, IsCompleteWhenItReturns) {
  auto& server = std::get<ServerPort<Joints>>(pair.server.ports);
  std::atomic<int> accepted = 0;
  auto calling = std::async(std::launch::async, [&] {
    pair.OnceInClient([&] {
      auto& client = std::get<ClientPort<Joints>>(pair.client.ports);
      while (true) {
        const Status status = client.reset();
        if (status == Status::kNotConnected) return;
        if (status) ++accepted;
        std::this_thread::yield();
      }
    });
  });
  ASSERT_TRUE(EventuallyTrue([&] { return accepted > 10; }));

  const bool is_complete = pair.Disconnect();
  const int executed = server.executed;

  calling.get();
  pair.OnceInServer([&] {
    EXPECT_EQ(server.executed, executed) << "after the disconnect";
    if (is_complete) {
      EXPECT_EQ(executed, accepted);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Parity, DisconnectUnderLoad, AllPairs(), NameOfPair);

TEST(ReferenceFault, AConnectionNeedsNoThread) {
  const auto threads = [] {
    const std::filesystem::directory_iterator entries("/proc/self/task");
    return std::distance(begin(entries), end(entries));
  };
  Pair pair(Kind::kSignal, Kind::kPeriodic);
  pair.Disconnect();
  const auto before = threads();

  pair.Connect();

  EXPECT_LE(threads(), before);  // an ended thread may still have been counted
}

TEST(ReferenceFault, SeveralManagersLiveInOneProcess) {
  auto first = std::make_unique<Pair>(Kind::kSignal, Kind::kPeriodic);
  Pair second(Kind::kPeriodic, Kind::kContinuous);
  const auto call = [](Pair& pair, int seed) {
    pair.InClient([seed](auto& port) {
      using P = PayloadIn<decltype(port)>;
      EXPECT_EQ(port.write.Wait(Sample<P>(seed), kLong), Status::kDone);
    });
  };
  const auto expect = [](Pair& pair, int seed) {
    pair.InServer([seed](auto& port) {
      ASSERT_EQ(port.received.size(), 1U);
      EXPECT_TRUE(IsSample(port.received.front(), seed));
    });
  };

  call(*first, 1);
  call(second, 2);

  expect(*first, 1);
  expect(second, 2);
  first.reset();
  call(second, 3);
}

/// A periodic task that ends after some cycles. It runs in its own thread or in a thread of the
/// test.
template <typename Base>
class Counted final : public Base {
 public:
  static constexpr std::uint64_t kCycles = 100;
  explicit Counted(std::string name) : Base(std::move(name), 1ms) {
    this->state_table().SetLength(2 * kCycles);
  }

 private:
  void Run() override {
    if (cycles_++ == kCycles) throw std::runtime_error("enough");
  }
  std::uint64_t cycles_ = 0;
};

/// Expects that the time of every row, minus its lateness, is on one grid.
void ExpectNoDrift(const tendon::StateTable& table, std::uint64_t rows) {
  ASSERT_EQ(table.next_tick(), rows);
  tendon::RowCopy row(table);
  const auto& column =
      dynamic_cast<const tendon::Column<tendon::CycleStatistics>&>(*table.Find("Cycle"));
  double first_due = 0.0;
  for (std::uint64_t tick = 0; tick < rows; ++tick) {
    tendon::CycleStatistics cycle;
    ASSERT_EQ(row.ReadAt(tick), RowResult::kDone);
    ASSERT_EQ(row.Get(column, cycle), RowResult::kDone);
    const double time = static_cast<double>(row.stamp().time.time_since_epoch().count());
    const double due = time - cycle.lateness * 1e9;
    if (tick == 0) first_due = due;
    EXPECT_NEAR(due, first_due + static_cast<double>(tick + cycle.overruns) * 1e6, 10.0) << tick;
  }
}

TEST(ReferenceFault, APeriodDoesNotDrift) {
  tendon::LocalManager manager;
  auto& own = manager.Add<Counted<tendon::PeriodicTask>>("own");
  auto& lent = manager.Add<Counted<tendon::MainTask>>("lent");
  ASSERT_TRUE(manager.StartAll(tendon::kNoWait).ok());
  ASSERT_TRUE(manager.WaitFor("lent", tendon::ComponentState::kActive, kLong).ok());

  lent.RunInThisThread();

  ASSERT_TRUE(manager.WaitFor("own", tendon::ComponentState::kFaulted, kLong).ok());
  ExpectNoDrift(*own.tables().front(), own.kCycles);
  ExpectNoDrift(*lent.tables().front(), lent.kCycles);
}

}  // namespace
}  // namespace tendon_test
