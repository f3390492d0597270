#pragma once

#include <gtest/gtest.h>
#include <tendon/middleware/loopback.h>
#include <tendon/proxy/provided_interface_proxy.h>
#include <tendon/proxy/required_interface_proxy.h>

#include <atomic>
#include <future>
#include <memory>
#include <mutex>
#include <vector>

namespace tendon {

inline constexpr std::uint32_t kClientHandle = 10;
inline constexpr std::uint32_t kServerHandle = 20;

/// The client's end of the channel.
struct ClientEnd final : ChannelHandler {
  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                std::span<const std::byte> body) override {
    if (header.type == message::kCredit) {
      EXPECT_EQ(header.handle, kClientHandle);
      const auto credit = *DecodeBody<message::Credit>(body);
      executed = credit.executed;
      if (!is_deaf) proxy->OnCredit(credit);
    } else if (header.type == message::kEventsLost) {
      EXPECT_EQ(header.handle, kClientHandle);
      proxy->OnEventsLost(*DecodeBody<message::EventsLost>(body));
    } else if (header.type == message::kEvents) {
      ForEachCall(body, [this](std::uint32_t handle, std::span<const std::byte> value) {
        proxy->OnEvent(handle - kClientHandle - 1, value);
      });
    }
  }
  void OnClosed(const std::shared_ptr<Channel>& /*channel*/, const Error& reason) override {
    const std::scoped_lock lock(mutex_);
    why_closed_ = reason.message;
  }
  std::string why_closed() {
    const std::scoped_lock lock(mutex_);
    return why_closed_;
  }
  std::atomic<bool> is_deaf{false};        // true: ignores credit
  std::atomic<std::uint64_t> executed{0};  // the count in the newest credit
  std::shared_ptr<ProvidedInterfaceProxy> proxy;

 private:
  std::mutex mutex_;
  std::string why_closed_;
};

/// The server's end of the channel.
struct ServerEnd final : ChannelHandler {
  void OnOpen(const std::shared_ptr<Channel>& opened, const Hello& /*peer*/) override {
    channel.set_value(opened);
  }
  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                std::span<const std::byte> body) override {
    if (header.type == message::kEventsLost) {
      EXPECT_EQ(header.handle, kServerHandle);
      return proxy->OnEventsLost(*DecodeBody<message::EventsLost>(body));
    }
    ASSERT_EQ(header.type, message::kCommands);
    const std::scoped_lock turn(gate);
    ForEachCall(body, [this](std::uint32_t handle, std::span<const std::byte> argument) {
      proxy->OnCommand(handle - kServerHandle - 1, argument);
    });
  }
  void OnRequest(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                 std::span<const std::byte> body, Responder responder) override {
    const std::uint32_t function = header.handle - kServerHandle - 1;
    if (header.type == message::kRead) {
      return proxy->OnRead(function, body, std::move(responder));
    }
    ASSERT_EQ(header.type, message::kWait);
    if (is_silent) {
      unanswered.push_back(std::move(responder));
      ++heard;
      return;
    }
    proxy->OnWait(function, body, std::move(responder));
  }
  std::mutex gate;  // while this is locked, no more frames are read from the link
  std::atomic<bool> is_silent{false};
  std::atomic<int> heard{0};
  std::vector<Responder> unanswered;
  std::promise<std::shared_ptr<Channel>> channel;
  std::shared_ptr<RequiredInterfaceProxy> proxy;
};

/// A read that requests room for its result, and then fails before it writes the result.
class TornRead final : public Offer {
 public:
  using Offer::Offer;

  std::unique_ptr<CommandBase> Bind(Mailbox* /*mailbox*/) const override {
    return std::make_unique<Command>();
  }

 private:
  class Command final : public CommandBase {
   public:
    Command() : CommandBase(layout::kNone, layout::kNone) {}
    Status ExecuteEncoded(std::span<const std::byte> /*in*/, ReplySink& out) override {
      (void)out.Room(sizeof(int));
      return Status::kFailed;
    }
  };
};

/// A required interface, a provided interface, and two proxies and a channel between them. The test
/// executes the calls in the inboxes.
class InterfaceProxies : public testing::Test {
 protected:
  InterfaceProxies() {
    server_inbox.SetAccepting(true);
    client_inbox.SetAccepting(true);
    provided.AddCommandWrite(&InterfaceProxies::Push, this, "Push");
    provided.AddCommandWrite(&InterfaceProxies::Load, this, "Load");
    provided.AddCommandRead(&InterfaceProxies::Count, this, "Count", kThreadSafe)
        .SetOverflow(Overflow::kLatestOnly);  // has no effect
    provided.AddCommandWrite(&InterfaceProxies::Follow, this, "Follow")
        .SetOverflow(Overflow::kLatestOnly);
    provided.AddOffer(
        std::make_unique<TornRead>(DescribeMember<None, int>("Torn", CommandKind::kRead)));
    provided.AddEvent(pushed, "Pushed");
    provided.AddEvent(moved, "Moved");
    required.AddFunction(push, "Push");
    required.AddFunction(load, "Load");
    required.AddFunction(count, "Count");
    required.AddFunction(missing, "Missing", Need::kOptional);
    required.AddFunction(follow, "Follow");
    required.AddFunction(torn, "Torn");
    required.AddEventHandlerWrite(&InterfaceProxies::OnPushed, this, "Pushed");
    required.AddEventHandlerWrite(&InterfaceProxies::OnMoved, this, "Moved")
        .SetOverflow(Overflow::kLatestOnly);
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
    server_end->proxy = std::make_shared<RequiredInterfaceProxy>(
        thread, server_end->channel.get_future().get(),
        message::OpenInterface{.description = required.description(),
                               .handle = kClientHandle,
                               .capacity = 4,
                               .latest_only = required.latest_only()});
    auto made = Connection::Make(server_end->proxy->interface(), provided, "client", "server");
    ASSERT_TRUE(made.ok()) << made.error().message;
    server_connection = *std::move(made);
  }
  void MakeClient() {
    required.SetMailboxCapacity(4);
    required.SetReadDeadline(std::chrono::seconds(20));
    client_end->proxy = std::make_shared<ProvidedInterfaceProxy>(
        thread, Remote(), required.description(), required.read_deadline());
    auto made = Connection::Make(required, client_end->proxy->interface(), "client", "server");
    ASSERT_TRUE(made.ok()) << made.error().message;
    client_connection = *std::move(made);
    (void)server_end->proxy->BeginCredit(
        *server_connection, {.interface = &provided, .fault = [] { return std::string(); }});
    thread->Add(*client_end->proxy);
    thread->Add(*server_end->proxy);
  }
  ProvidedInterfaceProxy::Remote Remote() {
    return {.channel = channel,
            .opened = {.handle = kServerHandle,
                       .credit = server_end->proxy->capacity(),
                       .accepting = true,
                       .description = provided.description(),
                       .latest_only = provided.latest_only()}};
  }

  void Push(int number) { numbers.push_back(number); }
  void Load(const std::vector<double>& values) { loads.push_back(values.size()); }
  void Count(int& answer) const { answer = 17; }
  void Follow(int number) { followed.push_back(number); }
  void OnPushed(int number) { heard.push_back(number); }
  void OnMoved(int number) { seen.push_back(number); }

  std::vector<int> numbers;
  std::vector<std::size_t> loads;
  std::vector<int> followed;  // only the latest values
  std::vector<int> heard;
  std::vector<int> seen;  // only the latest values

  Inbox server_inbox;
  ProvidedInterface provided{"Control", &server_inbox};
  WriteEvent<int> pushed;
  WriteEvent<int> moved;

  Inbox client_inbox;
  RequiredInterface required{"Robot", &client_inbox};
  WriteFunction<int> push;
  WriteFunction<std::vector<double>> load;
  ReadFunction<int> count;
  VoidFunction missing;
  WriteFunction<int> follow;
  ReadFunction<int> torn;

  std::shared_ptr<LoopbackNetwork> network = std::make_shared<LoopbackNetwork>();
  LoopbackMiddleware server{network};
  LoopbackMiddleware client{network};
  std::shared_ptr<NetworkThread> thread = std::make_shared<NetworkThread>();
  std::shared_ptr<ServerEnd> server_end = std::make_shared<ServerEnd>();
  std::shared_ptr<ClientEnd> client_end = std::make_shared<ClientEnd>();
  std::unique_ptr<Listener> listener;
  std::shared_ptr<Channel> channel;
  std::unique_ptr<Connection> server_connection;
  std::unique_ptr<Connection> client_connection;
};

}  // namespace tendon
