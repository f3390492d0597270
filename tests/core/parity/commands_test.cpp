#include "core/parity/two_processes.h"

namespace tendon_test {
namespace {

using tendon::Status;

/// Every kind of command.
using Commands = AnyPlacedPair;

TEST_P(Commands, VoidAndWriteCommandsRunInTheServersThread) {
  pair.InClient([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    for (int i = 1; i <= 20; ++i) EXPECT_EQ(port.write(Sample<P>(i)), pair.queued());
    EXPECT_EQ(port.reset(), pair.queued());
  });

  pair.Deliver();
  std::thread::id client;
  pair.OnceInClient([&] { client = std::this_thread::get_id(); });
  pair.InServer([&](auto& port) {
    EXPECT_EQ(port.resets, 1);
    if (std::get<1>(GetParam()) == Kind::kThreadless) {
      pair.ExpectInThreadOf(client, port.thread);
    } else {
      EXPECT_EQ(port.thread, std::this_thread::get_id());
    }
    ASSERT_EQ(port.received.size(), 20U);
    for (int i = 1; i <= 20; ++i) {
      EXPECT_TRUE(IsSample(port.received[static_cast<std::size_t>(i - 1)], i)) << i;
    }
  });
}

TEST_P(Commands, ReadsGiveTheNewestRow) {
  for (const int seed : {3, 30}) {
    pair.InServer([&](auto& port) { Fill(port.goal, seed); });
    pair.OnceInServer([&] { pair.server.Publish(); });

    pair.InClient([&](auto& port) {
      PayloadIn<decltype(port)> value;
      EXPECT_TRUE(EventuallyTrue([&] {  // a continuous task writes at most one row per millisecond
        return port.read(value) == Status::kDone && IsSample(value, seed);
      }));
    });
  }
}

TEST_P(Commands, QualifiedReadsTakeAnArgument) {
  pair.InServer([&](auto& port) { Fill(port.goal, 5); });
  pair.OnceInServer([&] { pair.server.Publish(); });

  pair.InClient([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    bool result = false;
    EXPECT_TRUE(EventuallyTrue(
        [&] { return port.is_at(Sample<P>(5), result) == Status::kDone && result; }));
    EXPECT_EQ(port.is_at(Sample<P>(6), result), Status::kDone);
    EXPECT_FALSE(result);
  });
}

TEST_P(Commands, ReturnsAreExecutedInTheServersThreadAndAnswered) {
  std::thread::id client;
  pair.InServer([&](auto& port) { Fill(port.goal, 7); });

  pair.InClient([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    client = std::this_thread::get_id();
    P value;
    EXPECT_EQ(port.take.Wait(value, kLong), Status::kDone);
    EXPECT_TRUE(IsSample(value, 7));
    EXPECT_EQ(port.swap.Wait(Sample<P>(8), value, kLong), Status::kDone);
    EXPECT_TRUE(IsSample(value, 7));
    EXPECT_EQ(port.take.Wait(value, kLong), Status::kDone);
    EXPECT_TRUE(IsSample(value, 8));
  });

  pair.InServer([&](auto& port) {
    if (std::get<1>(GetParam()) == Kind::kThreadless) {
      pair.ExpectInThreadOf(client, port.thread);
    } else {
      EXPECT_EQ(port.thread, std::this_thread::get_id());
    }
  });
}

TEST_P(Commands, AFilterRunsInTheCallersThreadAndItsOutputIsQueued) {
  std::uint64_t client = 0;
  pair.InClient([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    client = std::hash<std::thread::id>()(std::this_thread::get_id());
    EXPECT_EQ(port.write_filtered(Sample<P>(9)), pair.queued());
  });
  pair.Deliver();

  pair.InServer([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    ASSERT_EQ(port.filtered.size(), 1U);
    EXPECT_EQ(port.filtered[0].bytes, BytesOf(Sample<P>(9)).size());
    EXPECT_EQ(port.filtered[0].thread == client, !pair.is_remote());
  });
}

TEST_P(Commands, DirectCommandsRunInTheCallersThread) {
  pair.InClient([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    EXPECT_EQ(port.reset.Wait(kLong), Status::kDone);
    EXPECT_EQ(port.write_direct(Sample<P>(1)), pair.direct());
    std::int32_t count = 0;
    EXPECT_EQ(port.count(count), Status::kDone);
    EXPECT_EQ(count, 1);
  });

  std::thread::id client;
  pair.OnceInClient([&] { client = std::this_thread::get_id(); });
  pair.Deliver();
  pair.InServer([&](auto& port) { pair.ExpectInThreadOf(client, port.direct_thread); });
}

TEST_P(Commands, LatestOnlyCommandsAreNeverRefused) {
  pair.InClient([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    for (int i = 1; i <= 200; ++i) EXPECT_EQ(port.keep(Sample<P>(i)), pair.queued());
  });
  pair.Deliver();

  pair.InServer([&](auto& port) {
    ASSERT_FALSE(port.kept.empty());
    EXPECT_TRUE(IsSample(port.kept.back(), 200));
  });
}

INSTANTIATE_TEST_SUITE_P(Parity, Commands, AllPairsInOneProcess(), NameOfPlacedPair);
INSTANTIATE_TEST_SUITE_P(RemoteParity, Commands, testing::ValuesIn(RemotePairs()),
                         NameOfPlacedPair);

}  // namespace
}  // namespace tendon_test
