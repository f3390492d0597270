#include <algorithm>

#include "core/parity/pair.h"

namespace tendon_test {
namespace {

using tendon::Status;

/// Interfaces and their members.
using Interfaces = AnyPair;

TEST_P(Interfaces, AnOptionalInterfaceAndAnOptionalMemberMayStayEmpty) {
  pair.OnceInClient([&] { EXPECT_EQ(pair.client.optional(), Status::kNotConnected); });

  pair.InClient([&](auto& port) {
    EXPECT_EQ(port.missing(), Status::kNotConnected);
    EXPECT_FALSE(port.missing.is_connected());
    EXPECT_EQ(port.reset(), pair.queued());
  });
}

TEST_P(Interfaces, AnOptionalInterfaceIsFilledWhileBothRun) {
  std::atomic<int> steps = 0;
  pair.server.job = [&steps] { ++steps; };
  ASSERT_TRUE(pair.manager.Connect({"client", "Spare"}, {"server", "Desk"}).ok());

  pair.OnceInClient([&] { EXPECT_EQ(pair.client.optional.Wait(kLong), Status::kDone); });

  EXPECT_EQ(steps, 1);
}

TEST_P(Interfaces, ADisabledCommandDoesNotAffectOthers) {
  pair.InServer([](auto& port) { port.write->Disable(); });
  pair.InClient([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    EXPECT_EQ(port.write(Sample<P>(1)), Status::kDisabled);
    EXPECT_EQ(port.write.Wait(Sample<P>(2), kLong), Status::kDisabled);
    EXPECT_EQ(port.reset(), pair.queued());
  });

  pair.InServer([](auto& port) { port.write->Enable(); });
  pair.InClient([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    EXPECT_EQ(port.write(Sample<P>(3)), pair.queued());
  });

  pair.InServer([](auto& port) {
    EXPECT_EQ(port.resets, 1);
    ASSERT_EQ(port.received.size(), 1U);
    EXPECT_TRUE(IsSample(port.received[0], 3));
  });
}

TEST_P(Interfaces, ReconnectWhileBothRun) {
  for (int round = 1; round <= 3; ++round) {
    pair.InClient([&](auto& port) {
      using P = PayloadIn<decltype(port)>;
      EXPECT_EQ(port.write(Sample<P>(round)), pair.queued());
    });
    const bool is_complete = pair.Disconnect();
    pair.InServer([&](auto& port) {  // all accepted commands were executed
      if (is_complete) {
        EXPECT_EQ(port.received.size(), static_cast<std::size_t>(round));
      }
      port.done();
    });
    pair.InClient([](auto& port) {
      using P = PayloadIn<decltype(port)>;
      P value;
      bool result = false;
      EXPECT_EQ(port.write(Sample<P>(1)), Status::kNotConnected);
      EXPECT_EQ(port.reset.Wait(kLong), Status::kNotConnected);
      EXPECT_EQ(port.read(value), Status::kNotConnected);
      EXPECT_EQ(port.is_at(value, result), Status::kNotConnected);
      EXPECT_EQ(port.take.Wait(value, kLong), Status::kNotConnected);
      EXPECT_EQ(port.settled.Wait(value, kLong), Status::kNotConnected);
      EXPECT_EQ(port.dones, 0);
    });
    pair.Connect();
  }
}

INSTANTIATE_TEST_SUITE_P(Parity, Interfaces, AllPairs(), NameOfPair);

/// Full mailboxes of busy servers.
using FullMailbox = AnyPair;

TEST_P(FullMailbox, Of64Holds64AndRefusesTheRest) {
  pair.HoldServer();

  pair.InClient([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    for (int i = 1; i <= 64; ++i) EXPECT_EQ(port.write(Sample<P>(i)), Status::kQueued) << i;
    for (int i = 65; i <= 640; ++i) EXPECT_EQ(port.write(Sample<P>(i)), Status::kQueueFull) << i;
    EXPECT_EQ(port.reset(), Status::kQueueFull);
    // Keeps only the latest call, so it has a reserved slot.
    EXPECT_EQ(port.keep(Sample<P>(1)), Status::kQueued);
  });

  pair.Release();
  pair.InServer([&](auto& port) {
    ASSERT_EQ(port.received.size(), 64U);
    for (int i = 1; i <= 64; ++i) {
      EXPECT_TRUE(IsSample(port.received[static_cast<std::size_t>(i - 1)], i)) << i;
    }
    EXPECT_EQ(port.resets, 0);
    EXPECT_EQ(port.kept.size(), 1U);
  });
}

TEST_P(FullMailbox, HasTheClientsCapacity) {
  const auto set = [&](std::size_t capacity) {
    pair.Disconnect();
    for (const char* const port : kPortNames) {
      pair.client.component().FindRequired(port)->SetMailboxCapacity(capacity);
    }
    pair.Connect();
  };
  for (const int capacity : {1, 3, 100}) {
    set(static_cast<std::size_t>(capacity));
    pair.HoldServer();
    pair.InClient([&](auto& port) {
      using P = PayloadIn<decltype(port)>;
      for (int i = 0; i < capacity; ++i) EXPECT_EQ(port.write(Sample<P>(i)), Status::kQueued);
      EXPECT_EQ(port.write(Sample<P>(capacity)), Status::kQueueFull);
    });
    pair.Release();
  }
}

INSTANTIATE_TEST_SUITE_P(Parity, FullMailbox,
                         testing::Combine(testing::ValuesIn(AllKinds()),
                                          testing::ValuesIn(TaskKinds())),
                         NameOfPair);

}  // namespace
}  // namespace tendon_test
