#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <set>
#include <thread>

#include "core/interface/waiting_fixture.h"

namespace tendon_test {
namespace {

using tendon::CallerThreads;
using tendon::Connection;
using tendon::Status;

constexpr std::uint64_t kThreads = 3;

/// Runs `body(thread)` in several threads at once.
template <typename Body>
void InThreads(Body body) {
  std::atomic<std::uint64_t> ready = 0;
  std::array<std::jthread, kThreads> threads;
  for (std::uint64_t thread = 0; thread < kThreads; ++thread) {
    threads[thread] = std::jthread([&, thread] {
      ++ready;
      while (ready < kThreads) std::this_thread::yield();
      body(thread);
    });
  }
}

/// The argument of a call: its thread and its number, each twice.
struct Ticket {
  std::uint64_t thread = 0;
  std::uint64_t number = 0;
  std::uint64_t copy = 0;
};

}  // namespace
}  // namespace tendon_test

template <>
inline constexpr auto tendon::kPayload<tendon_test::Ticket> =
    tendon::Describe("test.Ticket", tendon::Field{"thread", &tendon_test::Ticket::thread},
                     tendon::Field{"number", &tendon_test::Ticket::number},
                     tendon::Field{"copy", &tendon_test::Ticket::copy});

namespace tendon_test {
namespace {

/// Counts calls that arrive out of order or torn.
struct Office {
  tendon::Inbox inbox;
  tendon::ProvidedInterface desk{"Desk", &inbox};
  tendon::StateTable table;
  Message row{.text = std::string(40, 'r'), .numbers = {}};

  std::array<std::uint64_t, kThreads> next{};
  std::uint64_t wrong = 0;
  std::uint64_t texts = 0;

  Office() {
    table.SetLength(8);
    table.Add(row, "Row", 256);
    desk.AddCommandWrite(&Office::Take, this, "Take");
    desk.AddCommandWrite(&Office::Say, this, "Say");
    desk.AddCommandWriteReturn(&Office::Double, this, "Double");
    desk.AddCommandQualifiedRead(table, row, &Lengthened, "Lengthened");
    table.Advance(tendon::SteadyClock().Now());
    inbox.SetAccepting(true);
  }

  void Take(const Ticket& ticket) {
    if (ticket.number != next[ticket.thread]++ || ticket.copy != ticket.number) ++wrong;
  }
  void Say(const std::string& text) {
    ++texts;
    if (text != std::string(text.size(), text.at(0))) ++wrong;
  }
  void Double(const std::int64_t& in, std::int64_t& out) { out = 2 * in; }
  static void Lengthened(const Message& row, const std::int32_t& by, std::int64_t& length) {
    length = static_cast<std::int64_t>(row.text.size()) + by;
  }
};

/// A component without a thread. Any thread may call its functions.
struct Public {
  tendon::RequiredInterface office{"Office", nullptr};
  tendon::WriteFunction<Ticket> take;
  tendon::WriteFunction<std::string> say;
  tendon::WriteReturnFunction<std::int64_t, std::int64_t> twice;
  tendon::QualifiedReadFunction<std::int32_t, std::int64_t> lengthened;

  Public() {
    office.AddFunction(take, "Take");
    office.AddFunction(say, "Say");
    office.AddFunction(twice, "Double");
    office.AddFunction(lengthened, "Lengthened");
    office.SetMailboxCapacity(8);
  }
};

struct Open {
  Office office;
  Public everybody;
  std::unique_ptr<Connection> connection = ConnectionOf(everybody.office, office.desk);
};

TEST(ManyCallers, KeepCallsOfOneFunctionCompleteAndInOrder) {
  constexpr std::uint64_t kCalls = 10'000;
  Open both;
  const Executor server(both.office.inbox);

  InThreads([&](std::uint64_t thread) {
    for (std::uint64_t number = 0; number < kCalls;) {
      if (both.everybody.take({thread, number, number})) {
        ++number;
      } else {
        std::this_thread::yield();
      }
    }
  });

  EXPECT_EQ(both.connection->Close(60s), 0U);
  EXPECT_EQ(both.office.wrong, 0U);
  for (const std::uint64_t received : both.office.next) EXPECT_EQ(received, kCalls);
}

TEST(ManyCallers, PassDynamicArgumentsCompletely) {
  constexpr int kCalls = 2000;
  Open both;
  const Executor server(both.office.inbox);
  std::atomic<std::uint64_t> accepted = 0;

  InThreads([&](std::uint64_t thread) {
    const std::string text(20 + 10 * thread, static_cast<char>('a' + thread));
    for (int i = 0; i < kCalls; ++i) {
      if (both.everybody.say(text)) ++accepted;
    }
  });

  EXPECT_EQ(both.connection->Close(60s), 0U);
  EXPECT_EQ(both.office.wrong, 0U);
  EXPECT_EQ(both.office.texts, accepted);
}

TEST(ManyCallers, GetTheirOwnReplies) {
  constexpr int kCalls = 500;
  Open both;
  const Executor server(both.office.inbox);
  std::atomic<int> wrong = 0;

  InThreads([&](std::uint64_t thread) {
    for (int i = 0; i < kCalls; ++i) {
      const std::int64_t question = static_cast<std::int64_t>(thread) * kCalls + i;
      std::int64_t result = 0;
      const Status status = both.everybody.twice.Wait(question, result, 60s);
      if (status != Status::kDone || result != 2 * question) ++wrong;
    }
  });

  EXPECT_EQ(wrong, 0);
}

TEST(ManyCallers, ReadAtTheSameTime) {
  constexpr std::int32_t kReads = 2000;
  Open both;
  std::atomic<int> wrong = 0;

  InThreads([&](std::uint64_t) {
    for (std::int32_t i = 0; i < kReads; ++i) {
      std::int64_t length = 0;
      if (!both.everybody.lengthened(i, length) || length != 40 + i) ++wrong;
    }
  });

  EXPECT_EQ(wrong, 0);
}

TEST(ManyCallers, ThroughTheCodecDoNotMixTheirValues) {
  Arm arm;
  tendon::RequiredInterface robot("Robot", nullptr);
  tendon::QualifiedReadFunction<std::int32_t, double> get_joint;
  tendon::ReadFunction<PaddedJointGoal> get_joints;
  robot.AddFunction(get_joint, "GetJoint");
  robot.AddFunction(get_joints, "GetJoints");
  arm.joints.position = {0, 1, 2, 3, 4, 5, 6};
  arm.Advance();
  const auto connection = Connection::Make(robot, arm.control, "desk/Robot", "arm/Control");
  ASSERT_TRUE(connection.ok());
  std::atomic<int> wrong = 0;

  InThreads([&](std::uint64_t) {
    for (int i = 0; i < 2000; ++i) {
      PaddedJointGoal joints;
      if (!get_joints(joints) || joints.position != arm.joints.position) ++wrong;
    }
  });

  EXPECT_EQ(wrong, 0);
}

TEST(ManyCallers, AreAllowedForATaskThatDeclaresThem) {
  Office office;
  tendon::Inbox inbox;
  inbox.BindToThisThread();
  tendon::RequiredInterface required("Office", &inbox);
  required.SetCallers(CallerThreads::kManyThreads);
  tendon::WriteFunction<Ticket> take;
  required.AddFunction(take, "Take");
  const auto connection = Connection::Make(required, office.desk, "driver/Office", "office/Desk");

  InThreads([&](std::uint64_t thread) { EXPECT_EQ(take({thread, 0, 0}), Status::kQueued); });

  EXPECT_EQ(office.inbox.ExecuteQueued(), kThreads);
  EXPECT_EQ(office.wrong, 0U);
}

TEST(ManyCallers, MayCallDuringADisconnect) {
  Office office;
  Public everybody;
  const Executor server(office.inbox);
  std::atomic<bool> is_over = false;
  std::atomic<std::uint64_t> accepted = 0;
  std::uint64_t dropped = 0;
  std::jthread manager([&] {
    for (int round = 0; round < 100; ++round) {
      auto connection =
          Connection::Make(everybody.office, office.desk, "public/Office", "office/Desk");
      const std::uint64_t before = accepted;
      while (accepted == before) std::this_thread::yield();
      dropped += (*connection)->Close(60s);
    }
    is_over = true;
  });

  InThreads([&](std::uint64_t thread) {
    const std::string text(30, static_cast<char>('a' + thread));
    while (!is_over) {
      std::int64_t result = 0;
      if (everybody.say(text)) ++accepted;
      (void)everybody.twice.Wait(1, result, 60s);
      (void)everybody.lengthened(1, result);
    }
  });
  manager.join();

  EXPECT_EQ(dropped, 0U);
  EXPECT_EQ(office.wrong, 0U);
  EXPECT_EQ(office.texts, accepted);
}

TEST(ManyRaisers, CountEveryEventThatDoesNotFit) {
  tendon::ProvidedInterface source("Source", nullptr);
  tendon::WriteEvent<Ticket> taken;
  source.AddEvent(taken, "Taken");
  Office office;
  tendon::RequiredInterface sink("Sink", &office.inbox);
  sink.AddEventHandlerWrite(&Office::Take, &office, "Taken");
  sink.SetMailboxCapacity(16);
  const auto connection = Connection::Make(sink, source, "office/Sink", "source/Source");

  InThreads([&](std::uint64_t thread) {
    for (std::uint64_t number = 0; number < 10; ++number) taken({thread, number, number});
  });

  EXPECT_EQ(office.inbox.ExecuteQueued(), 16U);
  EXPECT_EQ(taken.lost(), kThreads * 10 - 16);
  EXPECT_EQ((*connection)->lost_events(), taken.lost());
}

TEST(CallersDeathTest, ACallFromAnotherThreadAbortsADebugBuild) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  Planner planner;
  Operator client;
  const auto connection = Connect(client, planner);
  std::jthread([&] { client.inbox.BindToThisThread(); }).join();

  EXPECT_DEBUG_DEATH((void)client.slow(), "belong to its own thread");
}

}  // namespace
}  // namespace tendon_test
