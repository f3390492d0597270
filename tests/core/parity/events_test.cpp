#include <algorithm>
#include <future>

#include "core/parity/two_processes.h"
#include "support/log/log_record.h"

namespace tendon_test {
namespace {

using tendon::Status;
using namespace std::chrono_literals;

/// Events and their handlers.
using Events = AnyPlacedPair;

TEST_P(Events, QueuedHandlersRunInTheClientsThreadInOrder) {
  pair.InServer([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    for (int i = 1; i <= 20; ++i) port.reached(Sample<P>(i));
    port.done();
    EXPECT_EQ(port.reached.lost(), 0U);
  });
  pair.Deliver();

  std::thread::id server;
  pair.OnceInServer([&] { server = std::this_thread::get_id(); });
  const bool has_thread = std::get<0>(GetParam()) != Kind::kThreadless;
  pair.InClient([&](auto& port) {
    EXPECT_EQ(port.dones, 1);
    if (has_thread) {
      EXPECT_EQ(port.thread, std::this_thread::get_id());
    } else {
      pair.ExpectInThreadOf(server, port.thread);
    }
    ASSERT_EQ(port.reached.size(), 20U);
    for (int i = 1; i <= 20; ++i) {
      EXPECT_TRUE(IsSample(port.reached[static_cast<std::size_t>(i - 1)], i)) << i;
    }
    EXPECT_EQ(port.strange, 0);
  });
}

TEST_P(Events, DirectHandlersRunInTheRaisersThread) {
  std::thread::id server;
  pair.InServer([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    server = std::this_thread::get_id();
    port.passed(Sample<P>(1));
    port.passed(Sample<P>(2));
  });
  pair.Deliver();

  pair.InClient([&](auto& port) {
    pair.ExpectInThreadOf(server, port.direct_thread);
    ASSERT_EQ(port.passed.size(), 2U);
    EXPECT_TRUE(IsSample(port.passed[1], 2));
  });
}

TEST_P(Events, CanBeAwaitedWithADeadline) {
  pair.InClient([&](auto& port) {
    PayloadIn<decltype(port)> value;
    EXPECT_EQ(port.settled.Wait(value, 10us), Status::kTimeout);
  });
  auto raised = std::async(std::launch::async, [&] {
    pair.InServer([&](auto& port) {
      using P = PayloadIn<decltype(port)>;
      port.settled(Sample<P>(6));
    });
  });

  pair.InClient([&](auto& port) {
    PayloadIn<decltype(port)> value;
    EXPECT_EQ(port.settled.Wait(value, kLong), Status::kDone);
    EXPECT_TRUE(IsSample(value, 6));
  });
  raised.get();
}

TEST_P(Events, AreNotDeliveredWhileDisabled) {
  pair.InServer([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    port.reached.Disable();
    port.reached(Sample<P>(1));
    port.reached.Enable();
    port.reached(Sample<P>(2));
    EXPECT_EQ(port.reached.lost(), 0U);
  });
  pair.Deliver();

  pair.InClient([&](auto& port) {
    ASSERT_EQ(port.reached.size(), 1U);
    EXPECT_TRUE(IsSample(port.reached[0], 2));
  });
}

INSTANTIATE_TEST_SUITE_P(Parity, Events, AllPairsInOneProcess(), NameOfPlacedPair);
INSTANTIATE_TEST_SUITE_P(RemoteParity, Events, testing::ValuesIn(RemotePairs()), NameOfPlacedPair);

/// Clients with a thread, which can be busy.
using BusyClient = AnyPair;

TEST_P(BusyClient, MissesEventsWithoutRoomAndTheServerCountsThem) {
  pair.HoldClient();

  pair.InServer([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    for (int i = 1; i <= 100; ++i) port.reached(Sample<P>(i));
    EXPECT_EQ(port.reached.lost(), 36U);
  });

  pair.Release();
  pair.InClient([&](auto& port) {
    ASSERT_EQ(port.reached.size(), 64U);
    for (int i = 1; i <= 64; ++i) {
      EXPECT_TRUE(IsSample(port.reached[static_cast<std::size_t>(i - 1)], i)) << i;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Parity, BusyClient,
                         testing::Combine(testing::ValuesIn(TaskKinds()),
                                          testing::ValuesIn(AllKinds())),
                         NameOfPair);

/// Events with texts for people.
using MessageEvents = AnyPair;

TEST_P(MessageEvents, ReachTheClientAndTheLog) {
  const LogRecord log("server");
  pair.OnceInServer([&] {
    pair.server.messages->SendStatus("homed");
    pair.server.messages->SendWarning("warm");
    pair.server.messages->SendError("hot");
  });

  pair.OnceInClient([&] {
    EXPECT_EQ(pair.client.heard,
              (std::vector<std::string>{"status: homed", "warning: warm", "error: hot"}));
  });
  const std::vector<std::string> sent{"homed", "warm", "hot"};
  EXPECT_TRUE(EventuallyTrue([&] {  // a cycle passes its log records to another thread
    std::vector<std::string> said = log.texts();
    std::erase_if(said, [&](const auto& text) {  // on a busy machine, the watchdog also logs
      return std::find(sent.begin(), sent.end(), text) == sent.end();
    });
    return said == sent;
  }));
}

INSTANTIATE_TEST_SUITE_P(Parity, MessageEvents, AllPairs(), NameOfPair);

}  // namespace
}  // namespace tendon_test
