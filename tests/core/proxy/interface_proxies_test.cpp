#include <gtest/gtest.h>
#include <tendon/middleware/loopback.h>
#include <tendon/proxy/provided_interface_proxy.h>
#include <tendon/proxy/required_interface_proxy.h>

#include <atomic>
#include <future>
#include <mutex>

#include "support/wait.h"

namespace {

using tendon::Bytes;
using tendon::Channel;
using tendon::CommandKind;
using tendon::Connection;
using tendon::EncodeBody;
using tendon::FrameHeader;
using tendon::Hello;
using tendon::LoopbackMiddleware;
using tendon::None;
using tendon::Status;

constexpr std::uint32_t kClientHandle = 10;
constexpr std::uint32_t kServerHandle = 20;

/// The client's end of the channel.
struct ClientEnd final : tendon::ChannelHandler {
  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                std::span<const std::byte> body) override {
    if (header.type == tendon::message::kCredit) {
      EXPECT_EQ(header.handle, kClientHandle);
      proxy->OnCredit(*tendon::DecodeBody<tendon::message::Credit>(body));
    } else if (header.type == tendon::message::kEvents) {
      tendon::ForEachCall(body, [this](std::uint32_t handle, std::span<const std::byte> value) {
        proxy->OnEvent(handle - kClientHandle - 1, value);
      });
    }
  }
  std::shared_ptr<tendon::ProvidedInterfaceProxy> proxy;
};

/// The server's.
struct ServerEnd final : tendon::ChannelHandler {
  void OnOpen(const std::shared_ptr<Channel>& opened, const Hello& /*peer*/) override {
    channel.set_value(opened);
  }
  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                std::span<const std::byte> body) override {
    ASSERT_EQ(header.type, tendon::message::kCommands);
    const std::scoped_lock turn(gate);
    tendon::ForEachCall(body, [this](std::uint32_t handle, std::span<const std::byte> argument) {
      proxy->OnCommand(handle - kServerHandle - 1, argument);
    });
  }
  void OnRequest(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                 std::span<const std::byte> body, tendon::Responder responder) override {
    const std::uint32_t function = header.handle - kServerHandle - 1;
    if (header.type == tendon::message::kRead) {
      return proxy->OnRead(function, body, std::move(responder));
    }
    ASSERT_EQ(header.type, tendon::message::kWait);
    if (is_silent) {
      unanswered.push_back(std::move(responder));
      ++heard;
      return;
    }
    proxy->OnWait(function, body, std::move(responder));
  }
  std::mutex gate;  // while it is locked no more frames are taken from the link
  std::atomic<bool> is_silent{false};
  std::atomic<int> heard{0};
  std::vector<tendon::Responder> unanswered;
  std::promise<std::shared_ptr<Channel>> channel;
  std::shared_ptr<tendon::RequiredInterfaceProxy> proxy;
};

/// A required and a provided interface, and between them the two proxies and a channel. The test
/// executes what waits in the inboxes.
class InterfaceProxies : public testing::Test {
 protected:
  InterfaceProxies() {
    server_inbox.SetAccepting(true);
    client_inbox.SetAccepting(true);
    provided.AddCommandWrite(&InterfaceProxies::Push, this, "Push");
    provided.AddCommandWrite(&InterfaceProxies::Load, this, "Load");
    provided.AddCommandRead(&InterfaceProxies::Count, this, "Count", tendon::kThreadSafe);
    provided.AddEvent(pushed, "Pushed");
    required.AddFunction(push, "Push");
    required.AddFunction(load, "Load");
    required.AddFunction(count, "Count");
    required.AddFunction(missing, "Missing", tendon::Need::kOptional);
    required.AddEventHandlerWrite(&InterfaceProxies::OnPushed, this, "Pushed");
    OpenChannel();
    MakeServer();
    MakeClient();
  }
  ~InterfaceProxies() override {
    client_connection.reset();
    thread->Remove(*client_end->proxy);
    server_end->proxy->EndCredit();
    server_connection.reset();
    thread->Remove(*server_end->proxy);
    channel->Close();
    listener.reset();
  }

  void OpenChannel() {
    const Hello hello{.name = "test", .cookie = 1};
    auto listening =
        server.Listen("127.0.0.1:0", Channel::Acceptor(hello, [this] { return server_end; }));
    ASSERT_TRUE(listening.ok());
    listener = *std::move(listening);
    auto opened =
        Channel::Open(client, listener->address(), hello, client_end, std::chrono::seconds(20));
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    channel = *opened;
  }
  void MakeServer() {
    server_end->proxy = std::make_shared<tendon::RequiredInterfaceProxy>(
        thread, server_end->channel.get_future().get(),
        tendon::message::OpenInterface{
            .description = required.description(), .handle = kClientHandle, .capacity = 4});
    auto made = Connection::Make(server_end->proxy->interface(), provided, "client", "server");
    ASSERT_TRUE(made.ok()) << made.error().message;
    server_connection = *std::move(made);
  }
  void MakeClient() {
    required.SetMailboxCapacity(4);
    client_end->proxy = std::make_shared<tendon::ProvidedInterfaceProxy>(
        thread, Remote(), required.description(), required.read_deadline());
    auto made = Connection::Make(required, client_end->proxy->interface(), "client", "server");
    ASSERT_TRUE(made.ok()) << made.error().message;
    client_connection = *std::move(made);
    (void)server_end->proxy->BeginCredit(
        *server_connection, {.interface = &provided, .fault = [] { return std::string(); }});
    thread->Add(*client_end->proxy);
    thread->Add(*server_end->proxy);
  }
  tendon::ProvidedInterfaceProxy::Remote Remote() {
    return {.channel = channel,
            .opened = {.handle = kServerHandle,
                       .credit = server_end->proxy->capacity(),
                       .accepting = true,
                       .description = provided.description()}};
  }

  void Push(int number) { numbers.push_back(number); }
  void Load(const std::vector<double>& values) { loads.push_back(values.size()); }
  void Count(int& answer) const { answer = 17; }
  void OnPushed(int number) { heard.push_back(number); }

  std::vector<int> numbers;
  std::vector<std::size_t> loads;
  std::vector<int> heard;

  tendon::Inbox server_inbox;
  tendon::ProvidedInterface provided{"Control", &server_inbox};
  tendon::WriteEvent<int> pushed;

  tendon::Inbox client_inbox;
  tendon::RequiredInterface required{"Robot", &client_inbox};
  tendon::WriteFunction<int> push;
  tendon::WriteFunction<std::vector<double>> load;
  tendon::ReadFunction<int> count;
  tendon::VoidFunction missing;

  std::shared_ptr<tendon::LoopbackNetwork> network = std::make_shared<tendon::LoopbackNetwork>();
  LoopbackMiddleware server{network};
  LoopbackMiddleware client{network};
  std::shared_ptr<tendon::NetworkThread> thread = std::make_shared<tendon::NetworkThread>();
  std::shared_ptr<ServerEnd> server_end = std::make_shared<ServerEnd>();
  std::shared_ptr<ClientEnd> client_end = std::make_shared<ClientEnd>();
  std::unique_ptr<tendon::Listener> listener;
  std::shared_ptr<Channel> channel;
  std::unique_ptr<Connection> server_connection;
  std::unique_ptr<Connection> client_connection;
};

TEST_F(InterfaceProxies, SendNoMoreThanTheServerHasRoomForAndLoseNothing) {
  int accepted = 0;
  const bool is_full = EventuallyTrue([&] {
    while (push(accepted)) ++accepted;
    return accepted == 8;  // four in each mailbox
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

TEST_F(InterfaceProxies, PassOnWhetherTheServerExecutesCalls) {
  server_inbox.SetAccepting(false);
  thread->Notify();
  EXPECT_TRUE(EventuallyTrue([&] { return push(0) == Status(Status::kNotActive); }));

  server_inbox.SetAccepting(true);
  thread->Notify();
  EXPECT_TRUE(EventuallyTrue([&] { return push(1) == Status(Status::kQueued); }));
}

TEST_F(InterfaceProxies, CountACallThatTheServerRefusedAsDone) {
  server_inbox.SetAccepting(false);  // not yet known to the client
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

TEST_F(InterfaceProxies, RefuseWhatDoesNotFitIntoAFrame) {
  EXPECT_EQ(load(std::vector<double>(9'000'000)), Status(Status::kInvalid));
  EXPECT_EQ(load(std::vector<double>(100'000)), Status(Status::kQueued));

  EXPECT_TRUE(EventuallyTrue([&] {
    server_inbox.ExecuteQueued();
    return !loads.empty();
  }));
  EXPECT_EQ(loads, std::vector{std::size_t{100'000}});
}

TEST_F(InterfaceProxies, KeepWhatALinkHasNoRoomFor) {
  const std::vector<double> big(700'000);  // more than half of what may wait on a link
  int accepted = 0;
  EXPECT_TRUE(EventuallyTrue([&] {
    if (accepted < 30 && load(big)) ++accepted;
    server_inbox.ExecuteQueued();
    return loads.size() == 30;
  }));
  EXPECT_EQ(accepted, 30);
}

TEST_F(InterfaceProxies, AnswerReadsAtOnce) {
  int answer = 0;
  EXPECT_EQ(count(answer), Status(Status::kDone));
  EXPECT_EQ(answer, 17);
}

TEST_F(InterfaceProxies, LeaveAnOptionalFunctionWithoutACommand) {
  EXPECT_EQ(missing(), Status(Status::kNotConnected));
}

TEST_F(InterfaceProxies, BringEventsInOrder) {
  int raised = 0;
  EXPECT_TRUE(EventuallyTrue([&] {
    if (raised < 100 && raised - static_cast<int>(heard.size()) < 4) pushed(raised++);
    client_inbox.ExecuteQueued();
    return heard.size() == 100;
  }));
  for (int i = 0; i < 100; ++i) EXPECT_EQ(heard[static_cast<std::size_t>(i)], i);
  EXPECT_EQ(pushed.lost(), 0U);
}

TEST_F(InterfaceProxies, DoNotMixUpCommandsAndReads) {
  const auto read_of_a_write = channel->Call(tendon::message::kRead, kServerHandle + 1,
                                             EncodeBody(5), std::chrono::seconds(20));
  tendon::CallBatch calls;
  calls.Add(kServerHandle + 3, EncodeBody(None{}));
  calls.Add(kServerHandle + 99, EncodeBody(None{}));
  EXPECT_TRUE(channel->Notify(tendon::message::kCommands, 0, calls.body()));

  EXPECT_FALSE(read_of_a_write.ok());
  EXPECT_EQ(push(6), Status(Status::kQueued));
  EXPECT_TRUE(EventuallyTrue([&] {
    server_inbox.ExecuteQueued();
    return !numbers.empty();
  }));
  EXPECT_EQ(numbers, std::vector{6});
}

TEST_F(InterfaceProxies, AreNotMadeFromNonsense) {
  auto description = required.description();
  description.functions.front().name = "no name";
  auto remote = Remote();
  remote.opened.description.commands.front().name = "no name";

  EXPECT_THROW(tendon::RequiredInterfaceProxy(thread, channel, {.description = description}),
               tendon::ConfigurationError);
  EXPECT_THROW(tendon::ProvidedInterfaceProxy(thread, remote, description, std::chrono::seconds(1)),
               tendon::ConfigurationError);
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

TEST_F(InterfaceProxies, AWaitComesBehindTheCallsBeforeIt) {
  EXPECT_EQ(push(1), Status(Status::kQueued));
  EXPECT_EQ(push(2), Status(Status::kQueued));
  auto status =
      std::async(std::launch::async, [this] { return push.Wait(3, std::chrono::seconds(20)); });
  ASSERT_TRUE(EventuallyTrue([this] { return server_inbox.size() == 3; }));

  server_inbox.ExecuteQueued();

  EXPECT_EQ(status.get(), Status(Status::kDone));
  EXPECT_EQ(numbers, (std::vector{1, 2, 3}));
}

TEST_F(InterfaceProxies, AWaitEndsWithTheLinkWhetherItWasSentOrNot) {
  std::vector<std::future<Status>> statuses;
  statuses.push_back(
      std::async(std::launch::async, [this] { return push.Wait(1, std::chrono::seconds(20)); }));
  ASSERT_TRUE(EventuallyTrue([this] { return server_inbox.size() == 1; }));

  channel->Close();

  EXPECT_EQ(statuses.front().get(), Status(Status::kOutcomeUnknown));
  client_end->proxy->Sever();
  EXPECT_EQ(push.Wait(2, std::chrono::seconds(20)), Status(Status::kNotConnected));
}

TEST_F(InterfaceProxies, AWaitThatIsNotAnsweredEndsAtItsDeadline) {
  server_end->is_silent = true;

  Status first = Status::kTimeout;  // and not sent: the machine stood still
  EXPECT_TRUE(EventuallyTrue([&] {
    first = push.Wait(1, std::chrono::milliseconds(300));
    return first != Status(Status::kTimeout);
  }));

  EXPECT_EQ(first, Status(Status::kOutcomeUnknown));
  ASSERT_TRUE(EventuallyTrue([this] { return server_end->heard == 1; }));
  server_end->is_silent = false;
  server_end->unanswered.clear();  // refusals that nobody waits for any more
  auto status =
      std::async(std::launch::async, [this] { return push.Wait(2, std::chrono::seconds(20)); });
  ASSERT_TRUE(EventuallyTrue([this] { return server_inbox.ExecuteQueued() == 1; }));
  EXPECT_EQ(status.get(), Status(Status::kDone));
  EXPECT_EQ(numbers, (std::vector{2}));
}

TEST_F(InterfaceProxies, AWaitThatThereIsNoCreditForIsNotExecutedAfterItsDeadline) {
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

TEST_F(InterfaceProxies, AWaitIsNotEndedByAWordThatTheCallIsQueued) {
  server_end->is_silent = true;
  auto status =
      std::async(std::launch::async, [this] { return push.Wait(1, std::chrono::seconds(20)); });
  ASSERT_TRUE(EventuallyTrue([this] { return server_end->heard == 1; }));

  server_end->unanswered.front().Reply(Bytes{std::byte{Status::kQueued}});

  EXPECT_EQ(status.get(), Status(Status::kInvalid));
}

TEST_F(InterfaceProxies, AWaitThatALinkHasNoRoomForIsSentWholeOnceThereIs) {
  tendon::Wakeup<> wakeup;
  tendon::Outbox outbox(channel, tendon::message::kCommands, wakeup);
  const tendon::QueuedOfferProxy offer(provided.description().commands[1], outbox,
                                       kServerHandle + 2);
  tendon::Mailbox& mailbox = outbox.inbox().Open(4, {}, tendon::Callers::kManyThreads);
  const auto command = offer.Bind(&mailbox);
  const Bytes big = EncodeBody(std::vector<double>(700'000));
  Bytes nothing;
  std::unique_lock closed(server_end->gate);  // holds up the first; the second fills the link
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
