#include <gmock/gmock.h>
#include <tendon/proxy/worker_pool.h>
#include <tendon/task/signal_task.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <mutex>
#include <numeric>
#include <thread>
#include <vector>

#include "core/process/connections/remote_connection.h"

namespace {

using namespace std::chrono_literals;
using plant::Operator;
using tendon::InterfaceName;
using tendon::Status;

constexpr auto kSlowCodeTimeout = 120s;

/// A read command of the plant does not return while its gate is locked.
class SlowRead : public RemoteConnection {
 protected:
  SlowRead() {
    StartRobot();
    StartDesk();
    Connect();
  }
  /// Makes a read that times out. When this returns, the plant has received the request.
  void AskInVain(Operator& caller) {
    std::uint64_t result = 0;
    EXPECT_EQ(caller.ask(result), Status(Status::kTimeout));
  }
  void ExpectAllElseIsServed(Operator& caller) {
    plant::Move move;
    EXPECT_TRUE(EventuallyTrue([&] { return caller.get_move(move) == Status(Status::kDone); }));
    EXPECT_EQ(caller.move_to.Wait({.number = 7, .goal = {}}, kSlowCodeTimeout),
              Status(Status::kDone));
    EXPECT_TRUE(EventuallyQueued([&] { return caller.stop(); }));
  }
};

INSTANTIATE_TEST_SUITE_P(Over, SlowRead, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

TEST_P(SlowRead, BlocksNothingElseOnItsConnection) {
  const std::scoped_lock closed(plant->gate);

  AskInVain(*user);

  EXPECT_TRUE(EventuallyTrue([&] { return plant->asked == 1; }));
  ExpectAllElseIsServed(*user);
  EXPECT_TRUE(robot->is_joined());
}

TEST_P(SlowRead, FromMoreCallersThanThreadsBlocksNobodyElse) {
  std::vector<Operator*> callers;
  for (std::size_t i = 0; i < tendon::WorkerPool::kMax + 2; ++i) {
    const std::string name = "caller" + std::to_string(i);
    callers.push_back(&desk->Add<Operator>(name, 8));
    ASSERT_TRUE(desk->Connect(InterfaceName("desk", name, "Robot"), kControl).ok());
  }
  ASSERT_TRUE(EventuallyActive(*desk, callers.size() + 1));
  const std::scoped_lock closed(plant->gate);

  for (Operator* const caller : callers) AskInVain(*caller);

  EXPECT_TRUE(EventuallyTrue([&] { return plant->asked == int{tendon::WorkerPool::kMax}; }));
  for (Operator* const caller : callers) ExpectAllElseIsServed(*caller);
  ExpectAllElseIsServed(*user);
}

TEST_P(SlowRead, IsAnsweredOnceItsMethodReturns) {
  {
    const std::scoped_lock closed(plant->gate);
    AskInVain(*user);
  }
  std::uint64_t result = 0;

  EXPECT_TRUE(EventuallyTrue([&] { return user->ask(result) == Status(Status::kDone); }));

  EXPECT_EQ(result, 42U);
}

TEST_P(SlowRead, EndsWithItsConnection) {
  std::unique_lock closed(plant->gate);
  AskInVain(*user);
  ASSERT_TRUE(EventuallyTrue([&] { return plant->asked == 1; }));

  ASSERT_TRUE(desk->Disconnect(kRobot).ok());
  closed.unlock();
  Connect();

  std::uint64_t result = 0;
  EXPECT_TRUE(EventuallyTrue([&] { return user->ask(result) == Status(Status::kDone); }));
}

TEST_P(SlowRead, IsNotExecutedIfItsConnectionEndsFirst) {
  std::unique_lock closed(plant->gate);
  for (int i = 0; i < 3; ++i) AskInVain(*user);
  ASSERT_TRUE(EventuallyTrue([&] { return plant->asked == 1; }));
  ASSERT_TRUE(desk->Disconnect(kRobot).ok());
  Connect();  // waits for the previous requests
  EXPECT_TRUE(EventuallyTrue([&] { return Served() == 2; }))
      << "the plant is in a call of the first";

  closed.unlock();

  EXPECT_TRUE(EventuallyTrue([&] { return Served() == 1; })) << "it is freed";
  EXPECT_EQ(plant->asked, 1);
}

TEST_P(SlowRead, OfALostPeerBlocksNobody) {
  const std::scoped_lock closed(plant->gate);
  AskInVain(*user);
  ASSERT_TRUE(EventuallyTrue([&] { return plant->asked == 1; }));

  desk.reset();
  desk = Start("desk");
  user = &desk->Add<Operator>("operator");
  ASSERT_TRUE(desk->StartAll().ok());
  Connect();
  ExpectAllElseIsServed(*user);
}

const InterfaceName kScale("robot", "scale", "Control");
const InterfaceName kWeigher("desk", "weigher", "Scale");

/// The filter waits while this is locked.
std::mutex filter_gate;

void Rounded(const double& weight, int& rounded) {
  const std::scoped_lock lock(filter_gate);
  rounded = static_cast<int>(weight);
}

/// A scale with two commands to add weight. One command has a filter, which runs in the caller's
/// thread.
class Scale final : public tendon::SignalTask {
 public:
  explicit Scale(std::string name) : SignalTask(std::move(name)) {
    auto& control = AddProvidedInterface("Control");
    control.AddCommandFilteredWrite(&Rounded, &Scale::Put, this, "PutRounded");
    control.AddCommandWrite(&Scale::Put, this, "Put");
    control.AddCommandRead(&Scale::Count, this, "Count", tendon::kThreadSafe);
    control.AddCommandVoid(&Scale::Ring, this, "Ring", tendon::kThreadSafe);
    control.AddCommandVoid(&Scale::Jam, this, "Jam");
  }
  ~Scale() override { Join(); }

  void Run() override { ProcessQueuedCommands(); }

  plant::Record<int> weights;
  std::atomic<bool> is_jammed{false};
  std::atomic<int> jams{0};

 private:
  void Put(int weight) { weights.Add(weight); }
  void Ring() {}
  void Jam() {
    ++jams;
    while (is_jammed) std::this_thread::yield();
  }
  void Count(std::uint64_t& count) const { count = weights.size(); }
};

/// A component without a thread: the test calls its functions.
class Weigher final : public tendon::Component {
 public:
  explicit Weigher(std::string name)
      : Component(std::move(name), std::make_unique<tendon::Inbox>()) {
    auto& scale = AddRequiredInterface("Scale");
    scale.AddFunction(put_rounded, "PutRounded");
    scale.AddFunction(put, "Put");
    scale.AddFunction(count, "Count");
    scale.AddFunction(ring, "Ring");
    scale.AddFunction(jam, "Jam");
    scale.SetMailboxCapacity(kCapacity);
  }

  static constexpr int kCapacity = 32;
  tendon::WriteFunction<double> put_rounded;
  tendon::WriteFunction<int> put;
  tendon::ReadFunction<std::uint64_t> count;
  tendon::VoidFunction ring;
  tendon::VoidFunction jam;
};

/// A robot with a scale, and a desk that puts weights on it.
class SlowFilter : public NetworkTest {
 protected:
  SlowFilter() {
    scale = &robot->Add<Scale>("scale");
    weigher = &desk->Add<Weigher>("weigher");
    EXPECT_TRUE(robot->StartAll().ok());
    EXPECT_TRUE(desk->StartAll().ok());
    EXPECT_TRUE(desk->Connect(kWeigher, kScale).ok());
    EXPECT_TRUE(EventuallyActive(*desk, 1));
  }
  Status Put(int weight) {
    return weight % 2 == 0 ? weigher->put_rounded(weight + 0.25) : weigher->put(weight);
  }
  static std::vector<int> Weights(int count) {
    std::vector<int> weights(static_cast<std::size_t>(count));
    std::iota(weights.begin(), weights.end(), 0);
    return weights;
  }

  std::unique_ptr<tendon::Process> robot = Start("robot");
  std::unique_ptr<tendon::Process> desk = Start("desk");
  Scale* scale = nullptr;
  Weigher* weigher = nullptr;
};

INSTANTIATE_TEST_SUITE_P(Over, SlowFilter, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

TEST_P(SlowFilter, KeepsTheOrderOfAllCommandsOfItsConnection) {
  constexpr int kWeights = 300;

  for (int i = 0; i < kWeights; ++i) {
    if (i % 7 == 6) {
      ASSERT_EQ(weigher->put.Wait(i, kSlowCodeTimeout), Status(Status::kDone));
      EXPECT_EQ(scale->weights.size(), static_cast<std::size_t>(i + 1));
    } else {
      ASSERT_TRUE(EventuallyTrue([&] { return Put(i) == Status(Status::kQueued); }));
    }
  }

  EXPECT_EQ(weigher->put_rounded.Wait(kWeights, kSlowCodeTimeout), Status(Status::kDone));
  EXPECT_EQ(scale->weights.values(), Weights(kWeights + 1));
}

TEST_P(SlowFilter, AcceptsAMailboxfulAndRefusesTheRest) {
  std::unique_lock closed(filter_gate);
  int put = 0;
  while (Put(put) == Status(Status::kQueued)) ++put;

  // The calls fill a mailbox in the other process and, while they wait to be sent, a mailbox in
  // this process.
  EXPECT_GE(put, Weigher::kCapacity);
  EXPECT_LE(put, 2 * Weigher::kCapacity);
  EXPECT_EQ(scale->weights.size(), 0U);

  closed.unlock();
  EXPECT_TRUE(EventuallyTrue([&] { return Put(put) == Status(Status::kQueued); }));
  EXPECT_TRUE(EventuallyTrue([&] { return scale->weights.values() == Weights(put + 1); }));
}

TEST_P(SlowFilter, SkipsAWaitedCallAfterItsDeadline) {
  constexpr int kLate = 100;
  constexpr int kNext = 101;  // when this call ends, the time limit of the previous call has passed
  {
    const std::scoped_lock closed(filter_gate);
    EXPECT_EQ(Put(0), Status(Status::kQueued));
    EXPECT_FALSE(weigher->put.Wait(kLate, 20ms));
    EXPECT_FALSE(weigher->put.Wait(kNext, 2s));
  }

  EXPECT_EQ(weigher->put.Wait(1, kSlowCodeTimeout), Status(Status::kDone));
  const auto weights = scale->weights.values();
  EXPECT_EQ(weights.front(), 0);
  EXPECT_EQ(weights.back(), 1);
  EXPECT_EQ(std::ranges::count(weights, kLate), 0);
}

TEST_P(SlowFilter, DirectRepliesLoseNoQueuedCalls) {
  scale->is_jammed = true;
  ASSERT_EQ(weigher->jam(), Status(Status::kQueued));
  ASSERT_TRUE(EventuallyTrue([&] { return scale->jams == 1; }));
  int put = 0;
  for (; put < Weigher::kCapacity / 2; ++put) {
    ASSERT_EQ(weigher->put(put), Status(Status::kQueued));
  }
  // The first call waits behind calls that are not sent yet. Later calls are sent directly, except
  // while the network thread is sending; therefore, there are many.
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(weigher->ring.Wait(kSlowCodeTimeout), Status(Status::kDone));
  }
  // The desk keeps as many calls as its mailbox holds. The others are sent, more than the other
  // mailbox holds.
  for (; put < 2 * Weigher::kCapacity + Weigher::kCapacity / 4; ++put) {
    EXPECT_TRUE(EventuallyTrue([&] { return weigher->put(put) == Status(Status::kQueued); }));
  }

  scale->is_jammed = false;

  EXPECT_TRUE(EventuallyTrue([&] {
    return scale->weights.size() >= static_cast<std::size_t>(put);
  })) << scale->weights.size();
  EXPECT_EQ(scale->weights.values(), Weights(put));
}

TEST_P(SlowFilter, DropsQueuedCallsIfItHangsBeyondItsConnection) {
  std::unique_lock closed(filter_gate);
  for (int i = 0; i < 4; ++i) ASSERT_EQ(Put(i), Status(Status::kQueued));
  ASSERT_TRUE(desk->Disconnect(kWeigher).ok());
  ASSERT_TRUE(desk->Connect(kWeigher, kScale).ok());
  ASSERT_TRUE(EventuallyActive(*desk, 1));
  ASSERT_EQ(weigher->put.Wait(100, kSlowCodeTimeout), Status(Status::kDone));
  const auto serves = [&](std::size_t connections) {
    const auto all = robot->proxies();
    return all.size() == 1 && all.front().required.size() == connections;
  };
  EXPECT_TRUE(EventuallyTrue([&] { return serves(2); }));

  closed.unlock();

  EXPECT_TRUE(EventuallyTrue([&] { return serves(1); }));
  const auto weights = scale->weights.values();
  EXPECT_EQ(weights.front(), 100);
  EXPECT_LE(weights.size(), 2U) << "the one that hung may end";
}

TEST_P(SlowFilter, ExecutesArrivedCallsBeforeDisconnecting) {
  std::unique_lock closed(filter_gate);
  for (int i = 0; i < 10; ++i) ASSERT_EQ(Put(i), Status(Status::kQueued));
  auto disconnected = std::async(std::launch::async, [this] { return desk->Disconnect(kWeigher); });

  closed.unlock();
  EXPECT_TRUE(disconnected.get().ok());

  EXPECT_TRUE(EventuallyTrue([&] { return scale->weights.size() == 10; }));
  EXPECT_EQ(scale->weights.values(), Weights(10));
}

const InterfaceName kWatcher("desk", "watcher", "Robot");

/// Handles moves in the thread that raises the event. The handler waits while its gate is locked.
class Watcher final : public tendon::Component {
 public:
  explicit Watcher(std::string name) : Component(std::move(name)) {
    auto& robot = AddRequiredInterface("Robot");
    robot.AddEventHandlerWrite(&Watcher::OnMoved, this, "Moved", tendon::kThreadSafe);
    robot_ = &robot;
  }
  [[nodiscard]] std::uint64_t lost() const { return robot_->lost_events(); }

  std::mutex gate;
  std::atomic<int> entered{0};
  plant::Record<std::uint64_t> moves;

 private:
  void OnMoved(const plant::Move& move) {
    ++entered;
    const std::scoped_lock lock(gate);
    moves.Add(move.number);
  }

  tendon::RequiredInterface* robot_ = nullptr;
};

/// The desk also watches the moves of the robot.
class SlowHandler : public RemoteConnection {
 protected:
  SlowHandler() {
    StartRobot();
    StartDesk();
    Connect();
    watcher = &desk->Add<Watcher>("watcher");
    EXPECT_TRUE(desk->Connect(kWatcher, kControl).ok());
    EXPECT_TRUE(EventuallyActive(*desk, 2));
  }
  void Move(std::uint64_t number) {
    ASSERT_TRUE(EventuallyQueued([&] {
      user->Process();
      return user->move_to({.number = number, .goal = {}});
    }));
  }

  Watcher* watcher = nullptr;
};

INSTANTIATE_TEST_SUITE_P(Over, SlowHandler, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

TEST_P(SlowHandler, BlocksNothingElseThatItsProcessReceives) {
  std::unique_lock closed(watcher->gate);
  for (std::uint64_t i = 0; i < 10; ++i) Move(i);
  ASSERT_TRUE(EventuallyTrue([&] { return watcher->entered == 1; }));

  plant::Move move;
  EXPECT_TRUE(EventuallyTrue([&] { return user->get_move(move) == Status(Status::kDone); }));
  EXPECT_EQ(user->move_to.Wait({.number = 10, .goal = {}}, kSlowCodeTimeout),
            Status(Status::kDone));
  EXPECT_TRUE(EventuallyTrue([&] { return user->Process() > 0 && user->moved.size() >= 11; }));
  EXPECT_TRUE(desk->is_joined());

  closed.unlock();
  EXPECT_TRUE(EventuallyTrue([&] { return watcher->moves.size() == 11; }));
  std::vector<std::uint64_t> all(11);
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(watcher->moves.values(), all);
  EXPECT_EQ(watcher->lost(), 0U);
}

TEST_P(SlowHandler, CountsEventsThatFindNoRoom) {
  constexpr std::uint64_t kMoves = 5000;
  std::unique_lock closed(watcher->gate);
  for (std::uint64_t i = 0; i < kMoves; ++i) Move(i);
  ASSERT_TRUE(EventuallyTrue([&] { return plant->moves.size() == kMoves; }));
  ASSERT_EQ(user->move_to.Wait({}, kSlowCodeTimeout), Status(Status::kDone));
  closed.unlock();

  EXPECT_TRUE(EventuallyTrue([&] {
    Move(kMoves);  // the next event reports the lost events
    return watcher->lost() > 0 && watcher->moves.values().back() == kMoves &&
           watcher->moves.size() + watcher->lost() == plant->moves.size();
  }));
}

}  // namespace
