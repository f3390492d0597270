#include <support/peers/traced_channel.h>
#include <tendon/proxy/queued_offer_proxy.h>

#include <algorithm>

#include "core/proxy/interface_proxies.h"
#include "core/proxy/traced_argument.h"
#include "support/wait.h"

namespace tendon {
namespace {

/// The size of an argument of Load, and the number of bytes that may wait.
constexpr std::size_t kLoad = 1000;
constexpr std::uint64_t kMax = 3 * kLoad;

/// An outbox with little room, and a command that uses it.
class NarrowOutbox : public InterfaceProxies {
 protected:
  // The proxy gets no credit, because this test's own outbox sends the calls, not the proxy.
  NarrowOutbox() { client_end->is_deaf = true; }

  Status Post(std::size_t size) { return command->ExecuteEncoded(Bytes(size), nothing); }

  Wakeup<> wakeup;
  Outbox outbox{channel, message::kCommands, wakeup, "server", {.waiting_bytes = kMax}};
  const QueuedOfferProxy offer{provided.description().commands[1], outbox, kServerHandle + 2};
  Mailbox& mailbox = outbox.inbox().Open(1000, {}, CallerThreads::kManyThreads);
  const std::unique_ptr<CommandBase> command = offer.Bind(&mailbox);
  Bytes bytes;
  BytesSink nothing{bytes};
};

TEST_F(NarrowOutbox, RefusesCallsBeyondItsLimit) {
  for (int i = 0; i < 3; ++i) ASSERT_EQ(Post(kLoad), Status(Status::kQueued)) << i;

  EXPECT_EQ(Post(kLoad), Status(Status::kQueueFull));
  EXPECT_EQ(Post(0), Status(Status::kQueued)) << "it has room for what takes none";

  EXPECT_EQ(offer.refused(), 1U);
  EXPECT_EQ(mailbox.refused(), 1U);
  EXPECT_EQ(outbox.Send(), 4U);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(Post(kLoad), Status(Status::kQueued)) << i;
}

TEST_F(NarrowOutbox, AcceptsASingleLargerCall) {
  EXPECT_EQ(Post(10 * kLoad), Status(Status::kQueued));
  EXPECT_EQ(Post(kLoad), Status(Status::kQueueFull));

  EXPECT_EQ(outbox.Send(), 1U);

  EXPECT_EQ(Post(kLoad), Status(Status::kQueued));
}

TEST_F(NarrowOutbox, ReleasesTheRoomOfDroppedCalls) {
  for (int i = 0; i < 3; ++i) ASSERT_EQ(Post(kLoad), Status(Status::kQueued)) << i;
  while (mailbox.DropOne()) {
  }

  for (int i = 0; i < 3; ++i) EXPECT_EQ(Post(kLoad), Status(Status::kQueued)) << i;
}

/// An outbox with one command, on a channel that records the addresses of frames. The test sends.
class TracedOutbox : public testing::TestWithParam<Overflow> {
 protected:
  static constexpr std::uint32_t kHandle = 7;
  /// More than a batch may have.
  static constexpr std::size_t kLarge = 40'000;
  /// The place of the argument in a frame with one call.
  static constexpr std::size_t kFirstArgument = FrameHeader::kSize + 8;

  TracedOutbox() {
    offer.SetOverflow(GetParam());
    mailbox = &outbox.inbox().Open(8, offer.shape(), CallerThreads::kOneThread);
    command = offer.Bind(mailbox);
  }

  void Post(const ArgumentWriter& argument) {
    EXPECT_EQ(command->ExecuteFrom(argument, nothing), Status(Status::kQueued));
  }
  [[nodiscard]] std::vector<const std::byte*> FramePlaces() const {
    return channel.PlacesOf(message::kCommands);
  }
  /// Returns the bodies that arrive, at least `frames`.
  std::vector<Bytes> BodiesOf(std::size_t frames) {
    EXPECT_TRUE(EventuallyTrue([&] {
      channel->Expire(SteadyClock().Now());
      return channel.notices().size() >= frames;
    }));
    std::vector<Bytes> bodies;
    for (const auto& notice : channel.notices()) bodies.push_back(notice.body);
    return bodies;
  }
  static Bytes BodyOf(const std::vector<Bytes>& arguments) {
    CallBatch batch;
    for (const Bytes& argument : arguments) batch.Add(kHandle, argument);
    return {batch.body().begin(), batch.body().end()};
  }
  test::TracedChannel channel;
  Wakeup<> wakeup;
  Outbox outbox{channel.get(), message::kCommands, wakeup, "server"};
  QueuedOfferProxy offer{DescribeMember<int, None>("Push", CommandKind::kWrite), outbox, kHandle};
  Mailbox* mailbox = nullptr;
  std::unique_ptr<CommandBase> command;
  Bytes bytes;
  BytesSink nothing{bytes};
};

Bytes Filled(std::size_t size, std::byte fill) { return Bytes(size, fill); }

TEST_P(TracedOutbox, SendsASingleCallFromTheMemoryOfItsArgument) {
  for (const std::size_t size : {9, 100, 0, 5}) {
    const TracedArgument argument(size, std::byte{1});
    Post(argument);

    EXPECT_EQ(outbox.Send(), 1U);

    EXPECT_EQ(FramePlaces().back() + kFirstArgument, argument.places.at(0)) << size;
    EXPECT_EQ(BodiesOf(FramePlaces().size()).back(), BodyOf({Filled(size, std::byte{1})})) << size;
  }
  EXPECT_EQ(FramePlaces().size(), 4U);
}

TEST_P(TracedOutbox, SendsASingleCallWithItsTimeFromTheMemoryOfItsArgument) {
  Inbox inbox;
  const RequiredInterface source("Robot", &inbox);
  outbox.SendTimesOf(source);
  const TracedArgument argument(9, std::byte{1});
  Post(argument);

  EXPECT_EQ(outbox.Send(), 1U);

  EXPECT_EQ(FramePlaces().back() + kFirstArgument, argument.places.at(0));
  CallBatch expected;
  expected.AddTimed(kHandle, Filled(9, std::byte{1}), source.event_time());
  EXPECT_TRUE(std::ranges::equal(BodiesOf(1).at(0), expected.body()));
}

TEST_P(TracedOutbox, SendsACallLaterIfTheLinkHasNoRoom) {
  const TracedArgument first(9, std::byte{1});
  Post(first);
  channel.SetRoom(false);
  EXPECT_EQ(outbox.Send(), 0U);
  EXPECT_TRUE(outbox.is_held_up());
  const TracedArgument second(3, std::byte{2});
  Post(second);
  EXPECT_EQ(outbox.Send(), 0U);

  channel.SetRoom(true);
  EXPECT_EQ(outbox.Send(), 2U);

  EXPECT_FALSE(outbox.is_held_up());
  EXPECT_EQ(BodiesOf(2),
            (std::vector{BodyOf({Filled(9, std::byte{1})}), BodyOf({Filled(3, std::byte{2})})}));
}

TEST_P(TracedOutbox, DropsACallIfTheLinkIsLost) {
  Post(TracedArgument(9));
  channel->Close();

  EXPECT_EQ(outbox.Send(), 1U);

  EXPECT_FALSE(outbox.is_held_up());
  EXPECT_TRUE(FramePlaces().empty());
}

INSTANTIATE_TEST_SUITE_P(, TracedOutbox, testing::Values(Overflow::kRefuse, Overflow::kLatestOnly),
                         [](const auto& overflow) {
                           return overflow.param == Overflow::kRefuse ? "Queued" : "LatestOnly";
                         });

/// An outbox that sends all calls, not only the latest.
class TracedQueue : public TracedOutbox {};

TEST_P(TracedQueue, SendsSmallCallsTogetherInMemoryThatIsKept) {
  for (int round = 0; round < 2; ++round) {
    Post(TracedArgument(9, std::byte{1}));
    Post(TracedArgument(3, std::byte{2}));
    EXPECT_EQ(outbox.Send(), 2U);
  }

  const auto places = FramePlaces();
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[0], places[1]);
  const Bytes both = BodyOf({Filled(9, std::byte{1}), Filled(3, std::byte{2})});
  EXPECT_EQ(BodiesOf(2), (std::vector{both, both}));
}

TEST_P(TracedQueue, SendsALargeCallBetweenSmallOnesWithoutACopy) {
  const TracedArgument large(kLarge, std::byte{2});
  std::size_t sent = 0;
  std::vector<const std::byte*> places;
  const auto are_whole = [&] {  // at first, the channel sends small parts
    const std::size_t before = FramePlaces().size();
    Post(TracedArgument(9, std::byte{1}));
    Post(large);
    Post(TracedArgument(3, std::byte{3}));
    EXPECT_EQ(outbox.Send(), 3U);
    sent += 3;
    const auto bodies = BodiesOf(sent);
    EXPECT_EQ(
        std::vector(bodies.end() - 3, bodies.end()),
        (std::vector{BodyOf({Filled(9, std::byte{1})}), BodyOf({Filled(kLarge, std::byte{2})}),
                     BodyOf({Filled(3, std::byte{3})})}));
    places = FramePlaces();
    return places.size() == before + 3;
  };

  ASSERT_TRUE(EventuallyTrue(are_whole));

  EXPECT_EQ(*(places.end() - 2) + kFirstArgument, large.places.back());
}

TEST_P(TracedQueue, KeepsTheOrderOfALargeCallIfTheLinkHasNoRoom) {
  Post(TracedArgument(9, std::byte{1}));
  Post(TracedArgument(kLarge, std::byte{2}));
  channel.SetRoom(false);
  const std::size_t sent = outbox.Send();

  channel.SetRoom(true);
  EXPECT_EQ(sent + outbox.Send(), 2U);

  EXPECT_EQ(BodiesOf(1),
            (std::vector<Bytes>{BodyOf({Filled(9, std::byte{1}), Filled(kLarge, std::byte{2})})}));
}

TEST_P(TracedQueue, SendsNoMoreLargeCallsThanAllowed) {
  for (int i = 0; i < 5; ++i) Post(TracedArgument(kLarge));

  EXPECT_EQ(outbox.Send(2), 2U);
  EXPECT_EQ(mailbox->size(), 3U);
  EXPECT_EQ(outbox.Send(), 3U);
}

INSTANTIATE_TEST_SUITE_P(, TracedQueue, testing::Values(Overflow::kRefuse),
                         [](const auto& /*overflow*/) { return "Queued"; });

}  // namespace
}  // namespace tendon
