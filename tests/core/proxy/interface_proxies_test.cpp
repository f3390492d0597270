#include "core/proxy/interface_proxies.h"

#include <tendon/base/text.h>
#include <tendon/proxy/read_offer_proxy.h>

#include <algorithm>
#include <string>
#include <thread>

#include "support/wait.h"

namespace tendon {
namespace {

TEST_F(InterfaceProxies, SendOnlyWhatFitsTheServersMailbox) {
  int accepted = 0;
  const bool is_full = EventuallyTrue([&] {
    while (push(accepted)) ++accepted;
    return accepted == 8;  // four calls in each mailbox
  });
  ASSERT_TRUE(is_full) << accepted;
  EXPECT_TRUE(EventuallyTrue([&] { return server_inbox.size() == 4; }));
  EXPECT_EQ(push(0), Status(Status::kQueueFull));

  EXPECT_TRUE(EventuallyTrue([&] {
    server_inbox.ExecuteQueued();
    return numbers.size() == 8;
  }));

  EXPECT_EQ(numbers, (std::vector{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(push(0), Status(Status::kQueued));
}

TEST_F(InterfaceProxies, ReportWhetherTheServerExecutesCalls) {
  server_inbox.SetAccepting(false);
  thread->Notify();
  EXPECT_TRUE(EventuallyTrue([&] { return push(0) == Status(Status::kNotActive); }));

  server_inbox.SetAccepting(true);
  thread->Notify();
  EXPECT_TRUE(EventuallyTrue([&] { return push(1) == Status(Status::kQueued); }));
}

TEST_F(InterfaceProxies, CountARefusedCallAsDone) {
  server_inbox.SetAccepting(false);  // the client does not know this yet
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(EventuallyTrue([&] {
      const Status status = push(i);
      return status || status == Status(Status::kNotActive);
    }));
  }
  server_inbox.SetAccepting(true);
  thread->Notify();

  EXPECT_TRUE(EventuallyTrue([&] {
    (void)push(1000);
    server_inbox.ExecuteQueued();
    return !numbers.empty() && numbers.back() == 1000;
  }));
}

TEST_F(InterfaceProxies, RefuseCallsOnceTheyAreSevered) {
  client_end->proxy->Sever();

  EXPECT_EQ(push(0), Status(Status::kNotConnected));
}

TEST_F(InterfaceProxies, RefuseTooLargeArguments) {
  EXPECT_EQ(load(std::vector<double>(9'000'000)), Status(Status::kInvalid));
  EXPECT_EQ(load(std::vector<double>(100'000)), Status(Status::kQueued));

  EXPECT_TRUE(EventuallyTrue([&] {
    server_inbox.ExecuteQueued();
    return !loads.empty();
  }));
  EXPECT_EQ(loads, std::vector{std::size_t{100'000}});
}

TEST_F(InterfaceProxies, KeepCallsForAFullLink) {
  const std::vector<double> big(700'000);  // more than half of the bytes that may wait on a link
  int accepted = 0;
  EXPECT_TRUE(EventuallyTrue([&] {
    if (accepted < 30 && load(big)) ++accepted;
    server_inbox.ExecuteQueued();
    return loads.size() == 30;
  }));
  EXPECT_EQ(accepted, 30);
}

TEST_F(InterfaceProxies, SendInTheirOwnLanes) {
  Wakeup<> wakeup;
  const Outbox other(channel, message::kCommands, wakeup, "other");

  EXPECT_NE(client_end->proxy->lane(), kCommonLane);
  EXPECT_NE(client_end->proxy->lane(), other.lane());
  EXPECT_NE(server_end->proxy->lane(), kCommonLane);
}

TEST_F(InterfaceProxies, SendKeptCallsWhenTheConnectionEnds) {
  const std::vector<double> big(700'000);
  // Blocks the first call; the second call fills the link.
  std::unique_lock closed(server_end->gate);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(load(big), Status(Status::kQueued));
  EXPECT_TRUE(EventuallyTrue([&] { return client_connection->waiting() == 0; }));
  thread->Remove(*client_end->proxy);

  client_end->proxy->SendRest(std::chrono::milliseconds(0));  // the link still has no room
  closed.unlock();
  client_end->proxy->SendRest(std::chrono::seconds(20));

  EXPECT_TRUE(EventuallyTrue([&] {
    server_inbox.ExecuteQueued();
    return loads.size() == 3;
  }));
}

TEST_F(InterfaceProxies, AnswerReadsAtOnce) {
  int reply = 0;
  EXPECT_EQ(count(reply), Status(Status::kDone));
  EXPECT_EQ(reply, 17);
}

TEST_F(InterfaceProxies, AFailedReadLeaksNoEarlierAnswer) {
  int reply = 0;
  ASSERT_EQ(count(reply), Status(Status::kDone));

  const auto torn_answer = channel->Call(message::kRead, kServerHandle + 6, EncodeBody(None{}),
                                         std::chrono::seconds(20));

  ASSERT_TRUE(torn_answer.ok()) << torn_answer.error().message;
  Bytes failed(sizeof(int));
  AppendStatus(Status::kFailed, failed);
  EXPECT_TRUE(std::ranges::equal(torn_answer->body(), failed));
}

TEST_F(InterfaceProxies, LeaveAnOptionalFunctionWithoutACommand) {
  EXPECT_EQ(missing(), Status(Status::kNotConnected));
}

TEST_F(InterfaceProxies, DeliverEventsInOrder) {
  int raised = 0;
  EXPECT_TRUE(EventuallyTrue([&] {
    if (raised < 100 && raised - static_cast<int>(heard.size()) < 4) pushed(raised++);
    client_inbox.ExecuteQueued();
    return heard.size() == 100;
  }));
  for (int i = 0; i < 100; ++i) EXPECT_EQ(heard[static_cast<std::size_t>(i)], i);
  EXPECT_EQ(pushed.lost(), 0U);
}

TEST_F(InterfaceProxies, DoNotConfuseCommandsAndReads) {
  const auto read_of_a_write =
      channel->Call(message::kRead, kServerHandle + 1, EncodeBody(5), std::chrono::seconds(20));
  CallBatch calls;
  calls.Add(kServerHandle + 3, EncodeBody(None{}));
  calls.Add(kServerHandle + 99, EncodeBody(None{}));
  EXPECT_TRUE(channel->Notify(message::kCommands, 0, calls.body()));

  EXPECT_FALSE(read_of_a_write.ok());
  EXPECT_EQ(push(6), Status(Status::kQueued));
  EXPECT_TRUE(EventuallyTrue([&] {
    server_inbox.ExecuteQueued();
    return !numbers.empty();
  }));
  EXPECT_EQ(numbers, std::vector{6});
}

TEST_F(InterfaceProxies, RefuseInvalidDescriptions) {
  auto description = required.description();
  description.functions.front().name = "no name";
  auto remote = Remote();
  remote.opened.description.commands.front().name = "no name";

  EXPECT_THROW(RequiredInterfaceProxy(thread, channel, {.description = description}),
               ConfigurationError);
  EXPECT_THROW(ProvidedInterfaceProxy(thread, remote, description, std::chrono::seconds(1)),
               ConfigurationError);
}

TEST_F(InterfaceProxies, AWaitEndsWhenTheServerHasExecutedTheCall) {
  auto status =
      std::async(std::launch::async, [this] { return push.Wait(7, std::chrono::seconds(20)); });
  ASSERT_TRUE(EventuallyTrue([this] { return server_inbox.size() == 1; }));
  EXPECT_EQ(status.wait_for(std::chrono::seconds(0)), std::future_status::timeout);

  EXPECT_EQ(server_inbox.ExecuteQueued(), 1U);

  EXPECT_EQ(status.get(), Status(Status::kDone));
  EXPECT_EQ(numbers, (std::vector{7}));
}

TEST_F(InterfaceProxies, AWaitFollowsEarlierCalls) {
  EXPECT_EQ(push(1), Status(Status::kQueued));
  EXPECT_EQ(push(2), Status(Status::kQueued));
  auto status =
      std::async(std::launch::async, [this] { return push.Wait(3, std::chrono::seconds(20)); });
  ASSERT_TRUE(EventuallyTrue([this] { return server_inbox.size() == 3; }));

  server_inbox.ExecuteQueued();

  EXPECT_EQ(status.get(), Status(Status::kDone));
  EXPECT_EQ(numbers, (std::vector{1, 2, 3}));
}

TEST_F(InterfaceProxies, AWaitIsSentByItsCallerIfNothingIsQueued) {
  thread->Remove(*client_end->proxy);  // the proxy sends nothing any more
  auto status =
      std::async(std::launch::async, [this] { return push.Wait(1, std::chrono::seconds(20)); });
  ASSERT_TRUE(EventuallyTrue([this] { return server_inbox.size() == 1; }));

  server_inbox.ExecuteQueued();

  EXPECT_EQ(status.get(), Status(Status::kDone));
  EXPECT_EQ(numbers, (std::vector{1}));
}

TEST_F(InterfaceProxies, AWaitDoesNotOvertakeUnsentCalls) {
  thread->Remove(*client_end->proxy);
  EXPECT_EQ(push(1), Status(Status::kQueued));
  auto status =
      std::async(std::launch::async, [this] { return push.Wait(2, std::chrono::seconds(20)); });
  ASSERT_TRUE(EventuallyTrue([this] { return client_connection->waiting() == 2; }));
  EXPECT_EQ(server_inbox.size(), 0U);

  thread->Add(*client_end->proxy);

  ASSERT_TRUE(EventuallyTrue([this] { return server_inbox.size() == 2; }));
  server_inbox.ExecuteQueued();
  EXPECT_EQ(status.get(), Status(Status::kDone));
  EXPECT_EQ(numbers, (std::vector{1, 2}));
}

TEST_F(InterfaceProxies, WaitsAlwaysNeedCredit) {
  thread->Remove(*client_end->proxy);
  server_end->is_silent = true;
  for (int number = 0; number < 4; ++number) {
    // The time limit is long enough to send the call. The server does not answer.
    EXPECT_EQ(push.Wait(number, std::chrono::milliseconds(500)), Status(Status::kOutcomeUnknown));
  }
  ASSERT_TRUE(EventuallyTrue([this] { return server_end->heard == 4; }));

  EXPECT_EQ(push.Wait(4, std::chrono::milliseconds(20)), Status(Status::kTimeout));

  EXPECT_EQ(server_end->heard, 4);
  client_end->proxy->OnCredit({.executed = 1, .accepting = true, .fault = {}});
  server_end->is_silent = false;
  thread->Add(*client_end->proxy);  // drops calls that were not sent in time
  ASSERT_TRUE(EventuallyTrue([this] { return client_connection->waiting() == 0; }));
  auto status =
      std::async(std::launch::async, [this] { return push.Wait(5, std::chrono::seconds(20)); });
  ASSERT_TRUE(EventuallyTrue([this] { return server_inbox.ExecuteQueued() == 1; }));
  EXPECT_EQ(status.get(), Status(Status::kDone));
}

TEST_F(InterfaceProxies, AnAnsweredWaitReturnsCreditForEarlierCalls) {
  client_end->is_deaf = true;
  for (int i = 0; i < 5; ++i) {  // each round has three calls; four may be under way
    EXPECT_EQ(push(1), Status(Status::kQueued));
    EXPECT_EQ(push(2), Status(Status::kQueued));
    ASSERT_TRUE(EventuallyTrue([this] { return server_inbox.size() == 2; })) << i;
    thread->Remove(*client_end->proxy);  // the caller sends the next call itself
    auto status =
        std::async(std::launch::async, [this] { return push.Wait(3, std::chrono::seconds(20)); });
    ASSERT_TRUE(EventuallyTrue([this] { return server_inbox.size() == 3; })) << i;
    server_inbox.ExecuteQueued();
    ASSERT_EQ(status.get(), Status(Status::kDone)) << i;
    thread->Add(*client_end->proxy);
  }

  EXPECT_EQ(numbers.size(), 15U);
}

/// A server that executes quickly, until it is destroyed.
class Executor {
 public:
  explicit Executor(Inbox& inbox)
      : thread_([&inbox](const std::stop_token& stop) {
          while (!stop.stop_requested()) {
            if (inbox.ExecuteQueued() == 0) std::this_thread::yield();
          }
        }) {}

 private:
  std::jthread thread_;
};

TEST_F(InterfaceProxies, DecreasingCreditIsIgnored) {
  for (int number = 0; number < 4; ++number) EXPECT_TRUE(push(number));
  ASSERT_TRUE(EventuallyTrue([this] {
    server_inbox.ExecuteQueued();
    return client_end->executed == 4;
  }));

  client_end->proxy->OnCredit({.executed = 1, .accepting = true, .fault = {}});

  for (int number = 0; number < 4; ++number) EXPECT_TRUE(push(number));
  EXPECT_TRUE(EventuallyTrue([this] { return server_inbox.size() == 4; }));
  EXPECT_TRUE(channel->is_open());
}

TEST_F(InterfaceProxies, AHugeFaultTextIsKeptShortAndEscaped) {
  const std::string poison = "\x1b]0;owned\x07" + std::string(1'000'000, 'x');
  const message::Credit credit{.executed = 0, .accepting = true, .fault = poison};

  EXPECT_TRUE(client_end->proxy->OnCredit(credit));

  EXPECT_EQ(client_end->proxy->fault(), Printable(poison));
  EXPECT_FALSE(client_end->proxy->OnCredit(credit)) << "it is no news";
}

TEST_F(InterfaceProxies, CreditForUnsentCallsClosesTheChannel) {
  EXPECT_TRUE(push(1));
  ASSERT_TRUE(EventuallyTrue([this] { return server_inbox.size() == 1; }));

  client_end->proxy->OnCredit({.executed = 2, .accepting = true, .fault = {}});

  EXPECT_TRUE(EventuallyTrue([this] { return !channel->is_open(); }));
  EXPECT_TRUE(EventuallyTrue([this] {
    return client_end->why_closed() ==
           "test was disconnected: it acknowledged that 2 calls were executed, but only 1 "
           "were sent to it";
  })) << client_end->why_closed();
}

TEST_F(InterfaceProxies, ReportCreditAlsoForAnsweredWaits) {
  constexpr std::uint64_t kWaits = 100;
  const Executor executor(server_inbox);

  for (std::uint64_t i = 0; i < kWaits; ++i) {
    ASSERT_EQ(push.Wait(1, std::chrono::seconds(20)), Status(Status::kDone));
  }

  EXPECT_TRUE(EventuallyTrue([&] { return client_end->executed == kWaits; }));
}

TEST_F(InterfaceProxies, AWaitEndsWithTheLinkSentOrNot) {
  std::vector<std::future<Status>> statuses;
  statuses.push_back(
      std::async(std::launch::async, [this] { return push.Wait(1, std::chrono::seconds(20)); }));
  ASSERT_TRUE(EventuallyTrue([this] { return server_inbox.size() == 1; }));

  channel->Close();

  EXPECT_EQ(statuses.front().get(), Status(Status::kOutcomeUnknown));
  client_end->proxy->Sever();
  EXPECT_EQ(push.Wait(2, std::chrono::seconds(20)), Status(Status::kNotConnected));
}

TEST_F(InterfaceProxies, AWaitRefusedByTheLinkEndsAtOnce) {
  channel->Close();
  EXPECT_EQ(push.Wait(1, std::chrono::seconds(20)), Status(Status::kNotConnected));

  thread->Remove(*client_end->proxy);
  EXPECT_EQ(push(2), Status(Status::kQueued));
  auto status =
      std::async(std::launch::async, [this] { return push.Wait(3, std::chrono::seconds(20)); });
  ASSERT_TRUE(EventuallyTrue([this] { return client_connection->waiting() == 2; }));
  thread->Add(*client_end->proxy);

  EXPECT_EQ(status.get(), Status(Status::kNotConnected));
}

TEST_F(InterfaceProxies, AnUnansweredWaitEndsAtItsDeadline) {
  server_end->is_silent = true;

  Status first = Status::kTimeout;  // a time-out before sending means that the machine stalled
  EXPECT_TRUE(EventuallyTrue([&] {
    first = push.Wait(1, std::chrono::milliseconds(300));
    return first != Status(Status::kTimeout);
  }));

  EXPECT_EQ(first, Status(Status::kOutcomeUnknown));
  ASSERT_TRUE(EventuallyTrue([this] { return server_end->heard == 1; }));
  server_end->is_silent = false;
  server_end->unanswered.clear();  // refusals for which nobody waits any more
  auto status =
      std::async(std::launch::async, [this] { return push.Wait(2, std::chrono::seconds(20)); });
  ASSERT_TRUE(EventuallyTrue([this] { return server_inbox.ExecuteQueued() == 1; }));
  EXPECT_EQ(status.get(), Status(Status::kDone));
  EXPECT_EQ(numbers, (std::vector{2}));
}

TEST_F(InterfaceProxies, AWaitWithoutCreditIsNotExecutedLate) {
  for (int number = 0; number < 4; ++number) {
    EXPECT_EQ(push(number), Status(Status::kQueued));
  }
  ASSERT_TRUE(EventuallyTrue([this] { return server_inbox.size() == 4; }));

  EXPECT_EQ(push.Wait(4, std::chrono::milliseconds(20)), Status(Status::kTimeout));

  EXPECT_TRUE(EventuallyTrue([this] { return server_inbox.ExecuteQueued() == 0; }));
  EXPECT_TRUE(EventuallyTrue([this] { return push(5) == Status(Status::kQueued); }));
  EXPECT_TRUE(EventuallyTrue([this] { return server_inbox.ExecuteQueued() == 1; }));
  EXPECT_EQ(numbers, (std::vector{0, 1, 2, 3, 5}));
}

TEST_F(InterfaceProxies, AReplyOfQueuedIsInvalidForAWait) {
  server_end->is_silent = true;
  auto status =
      std::async(std::launch::async, [this] { return push.Wait(1, std::chrono::seconds(20)); });
  ASSERT_TRUE(EventuallyTrue([this] { return server_end->heard == 1; }));

  server_end->unanswered.front().Reply(Bytes{std::byte{Status::kQueued}});

  EXPECT_EQ(status.get(), Status(Status::kInvalid));
}

TEST_F(InterfaceProxies, AWaitForAFullLinkIsSentOnceThereIsRoom) {
  // The proxy gets no credit, because this test's own outbox sends the calls, not the proxy.
  client_end->is_deaf = true;
  Wakeup<> wakeup;
  Outbox outbox(channel, message::kCommands, wakeup, "server");
  const QueuedOfferProxy offer(provided.description().commands[1], outbox, kServerHandle + 2);
  Mailbox& mailbox = outbox.inbox().Open(4, {}, CallerThreads::kManyThreads);
  const auto command = offer.Bind(&mailbox);
  const Bytes big = EncodeBody(std::vector<double>(700'000));
  Bytes bytes;
  BytesSink nothing(bytes);
  // Blocks the first call; the second call fills the link.
  std::unique_lock closed(server_end->gate);
  EXPECT_TRUE(command->ExecuteEncoded(big, nothing));
  EXPECT_TRUE(command->ExecuteEncoded(big, nothing));
  auto status = std::async(std::launch::async, [&] {
    Bytes out;
    return command->WaitEncoded(big, out, std::chrono::seconds(60));
  });
  std::size_t sent = 0;
  EXPECT_TRUE(EventuallyTrue([&] {
    sent += outbox.Send(10);
    return sent == 2 && outbox.is_held_up();
  }));

  for (int i = 0; i < 3; ++i) EXPECT_EQ(outbox.Send(10), 0U);
  closed.unlock();

  EXPECT_TRUE(EventuallyTrue([&] {
    (void)outbox.Send(10);
    server_inbox.ExecuteQueued();
    return loads.size() == 3;
  }));
  EXPECT_EQ(status.get(), Status(Status::kDone));
  EXPECT_EQ(loads, std::vector(3, std::size_t{700'000}));
}

}  // namespace
}  // namespace tendon
