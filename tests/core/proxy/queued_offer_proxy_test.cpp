#include <tendon/proxy/queued_offer_proxy.h>

#include <algorithm>
#include <set>

#include "core/proxy/interface_proxies.h"
#include "core/proxy/traced_argument.h"
#include "support/allocation_guard.h"
#include "support/wait.h"

namespace tendon {
namespace {

/// The command "Load" of another process, with its own outbox.
class RemoteCommand : public InterfaceProxies, public testing::WithParamInterface<Overflow> {
 protected:
  static constexpr std::size_t kCapacity = 4;
  static constexpr std::size_t kSize = 1000;

  RemoteCommand() {
    // The proxy gets no credit, because this test's own outbox sends the calls, not the proxy.
    client_end->is_deaf = true;
    offer.SetOverflow(GetParam());
    mailbox = &outbox.inbox().Open(kCapacity, offer.shape(), CallerThreads::kManyThreads);
    command = offer.Bind(mailbox);
  }

  Status Call(const ArgumentWriter& argument) { return command->ExecuteFrom(argument, nothing); }

  Wakeup<> wakeup;
  Outbox outbox{channel, message::kCommands, wakeup, "server", {.waiting_bytes = 4 * kSize}};
  QueuedOfferProxy offer{provided.description().commands[1], outbox, kServerHandle + 2};
  Mailbox* mailbox = nullptr;
  std::unique_ptr<CommandBase> command;
  Bytes bytes;
  BytesSink nothing{bytes};
};

TEST_P(RemoteCommand, WritesItsArgumentOnce) {
  const TracedArgument argument(kSize);

  EXPECT_EQ(Call(argument), Status(Status::kQueued));

  EXPECT_EQ(argument.places.size(), 1U);
  EXPECT_EQ(outbox.Send(), 1U);
}

TEST_P(RemoteCommand, AllocatesNothingOnceWarm) {
  TracedArgument argument(kSize);
  argument.places.reserve(100);
  const auto call_all = [&] {
    for (std::size_t i = 0; i < kCapacity; ++i) EXPECT_EQ(Call(argument), Status(Status::kQueued));
  };
  for (int round = 0; round < 3; ++round) {
    call_all();
    while (mailbox->DropOne()) continue;
  }

  const AllocationGuard guard;
  call_all();
}

TEST_P(RemoteCommand, AllocatesNothingForArgumentsOfChangingSizes) {
  TracedArgument large(kSize);
  TracedArgument small(8);
  large.places.reserve(100);
  small.places.reserve(100);
  for (std::size_t i = 0; i < 3 * kCapacity; ++i) {
    EXPECT_EQ(Call(large), Status(Status::kQueued));
    EXPECT_EQ(outbox.Send(), 1U);
  }

  for (std::size_t i = 0; i < 4 * kCapacity; ++i) {
    {
      const AllocationGuard guard;
      EXPECT_EQ(Call(i % 3 == 0 ? large : small), Status(Status::kQueued));
    }
    EXPECT_EQ(outbox.Send(), 1U);
  }
}

TEST_P(RemoteCommand, AThrowingArgumentDoesNotBlockIt) {
  TracedArgument broken(4 * kSize);
  broken.throws = true;
  for (std::size_t i = 0; i < 2 * kCapacity; ++i) {
    EXPECT_EQ(Call(broken), Status(Status::kFailed)) << i;
    outbox.Send();
  }

  const TracedArgument argument(4 * kSize);  // as many bytes as may wait
  EXPECT_EQ(Call(argument), Status(Status::kQueued));

  EXPECT_EQ(outbox.Send(), 1U);
  EXPECT_EQ(offer.refused(), 2 * kCapacity);
}

TEST_P(RemoteCommand, SendsNothingIfTheArgumentChangesMeanwhile) {
  TracedArgument changing(kSize);
  changing.changes = true;

  EXPECT_EQ(Call(changing), Status(Status::kFailed));

  EXPECT_EQ(outbox.Send(), 0U);
  EXPECT_EQ(offer.refused(), 1U);
}

TEST_P(RemoteCommand, WritesNoTooLargeArgument) {
  const TracedArgument argument(kMaxPayload + 1);

  EXPECT_EQ(Call(argument), Status(Status::kInvalid));

  EXPECT_TRUE(argument.places.empty());
  EXPECT_EQ(mailbox->size(), 0U);
  EXPECT_EQ(offer.refused(), 1U);
}

TEST_P(RemoteCommand, WritesNoArgumentOnceItsOutboxIsClosed) {
  const TracedArgument argument(kSize);
  outbox.Close();

  EXPECT_EQ(Call(argument), Status(Status::kNotConnected));

  EXPECT_TRUE(argument.places.empty());
}

TEST_P(RemoteCommand, WritesNoArgumentIntoAClosedMailbox) {
  const TracedArgument argument(kSize);
  mailbox->Close();

  EXPECT_EQ(Call(argument), Status(Status::kNotConnected));

  EXPECT_TRUE(argument.places.empty());
  EXPECT_EQ(mailbox->size(), 0U);
}

TEST_P(RemoteCommand, SendsEncodedBytes) {
  const Bytes values = EncodeBody(std::vector<double>(7));

  EXPECT_EQ(command->ExecuteEncoded(values, nothing), Status(Status::kQueued));
  EXPECT_EQ(outbox.Send(), 1U);

  EXPECT_TRUE(EventuallyTrue([&] {
    server_inbox.ExecuteQueued();
    return !loads.empty();
  }));
  EXPECT_EQ(loads, std::vector{std::size_t{7}});
}

INSTANTIATE_TEST_SUITE_P(, RemoteCommand, testing::Values(Overflow::kRefuse, Overflow::kLatestOnly),
                         [](const auto& overflow) {
                           return overflow.param == Overflow::kRefuse ? "Queued" : "LatestOnly";
                         });

/// A command with a slot for each waiting call.
class QueuedRemoteCommand : public RemoteCommand {};

TEST_P(QueuedRemoteCommand, WritesEachArgumentIntoItsSlotsBuffer) {
  const TracedArgument argument(kSize);
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < kCapacity; ++i) {
      EXPECT_EQ(Call(argument), Status(Status::kQueued));
    }
    EXPECT_EQ(Call(argument), Status(Status::kQueueFull));
    EXPECT_EQ(outbox.Send(), kCapacity);
  }

  ASSERT_EQ(argument.places.size(), 2 * kCapacity) << "what is refused is not written";
  const auto second = argument.places.begin() + kCapacity;
  EXPECT_TRUE(std::equal(argument.places.begin(), second, second)) << "slots keep their buffers";
  EXPECT_EQ(std::set<const std::byte*>(argument.places.begin(), second).size(), kCapacity);
}

TEST_P(QueuedRemoteCommand, SendsASmallerArgumentAfterALargerOne) {
  for (const std::size_t length : {100, 7, 50}) {
    const Bytes values = EncodeBody(std::vector<double>(length));
    for (std::size_t i = 0; i < kCapacity; ++i) {
      EXPECT_EQ(command->ExecuteEncoded(values, nothing), Status(Status::kQueued));
    }
    EXPECT_EQ(outbox.Send(), kCapacity);
    EXPECT_TRUE(EventuallyTrue([&] {
      server_inbox.ExecuteQueued();
      return !loads.empty() && loads.size() % kCapacity == 0 && loads.back() == length;
    }));
  }

  EXPECT_EQ(loads, (std::vector<std::size_t>{100, 100, 100, 100, 7, 7, 7, 7, 50, 50, 50, 50}));
}

INSTANTIATE_TEST_SUITE_P(, QueuedRemoteCommand, testing::Values(Overflow::kRefuse),
                         [](const auto& /*overflow*/) { return "Queued"; });

}  // namespace
}  // namespace tendon
