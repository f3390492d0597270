#include <support/peers/traced_channel.h>
#include <tendon/proxy/queued_command_proxy.h>

#include <thread>

#include "core/proxy/interface_proxies.h"
#include "support/wait.h"

namespace tendon {
namespace {

/// The size of an argument of Load, and the number of bytes that may wait.
constexpr std::size_t kLoad = 1000;
constexpr std::uint64_t kMost = 3 * kLoad;

/// An outbox with little room, and a command that uses it.
class NarrowOutbox : public InterfaceProxies {
 protected:
  // The proxy gets no credit, because this test's own outbox sends the calls, not the proxy.
  NarrowOutbox() { client_end->is_deaf = true; }

  Status Post(std::size_t size) { return command->ExecuteEncoded(Bytes(size), nothing); }

  Wakeup<> wakeup;
  Outbox outbox{channel, message::kCommands, wakeup, "server", {.waiting_bytes = kMost}};
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

/// An outbox with one command, on a channel that records the addresses of frames.
struct TracedOutbox {
  TracedOutbox(const test::TracedChannel& channel, std::uint32_t handle)
      : outbox(channel.get(), message::kCommands, wakeup, "server"),
        offer(DescribeMember<int, None>("Push", CommandKind::kWrite), outbox, handle) {}

  void Send(int number) {
    BytesSink nothing(bytes);
    EXPECT_EQ(command->ExecuteEncoded(EncodeBody(number), nothing), Status(Status::kQueued));
    EXPECT_EQ(outbox.Send(), 1U);
  }

  Wakeup<> wakeup;
  Outbox outbox;
  QueuedOfferProxy offer;
  Mailbox& mailbox = outbox.inbox().Open(4, {}, CallerThreads::kOneThread);
  std::unique_ptr<CommandBase> command = offer.Bind(&mailbox);
  Bytes bytes;
};

TEST(Outbox, SendsEachBatchWithoutACopy) {
  const test::TracedChannel channel;
  TracedOutbox first(channel, 1);
  TracedOutbox second(channel, 2);

  first.Send(10);
  second.Send(20);
  first.Send(30);

  const auto places = channel.PlacesOf(message::kCommands);
  ASSERT_EQ(places.size(), 3U);
  EXPECT_NE(places[0], places[1]) << "there is no common buffer";
  EXPECT_EQ(places[0], places[2]) << "a batch keeps its memory";
  ASSERT_TRUE(EventuallyTrue([&] { return channel.notices().size() == 3; }));
  ForEachCall(channel.notices()[2].body,
              [](std::uint32_t handle, std::span<const std::byte> argument) {
                EXPECT_EQ(handle, 1U);
                EXPECT_EQ(Bytes(argument.begin(), argument.end()), EncodeBody(30));
              });
}

}  // namespace
}  // namespace tendon
