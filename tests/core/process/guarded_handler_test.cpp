#include <gmock/gmock.h>
#include <tendon/base/os/process.h>
#include <tendon/gcm/client.h>
#include <tendon/process/guarded_handler.h>
#include <tendon/process/viewer_messages.h>
#include <tendon/proxy/connection_messages.h>

#include <string>
#include <vector>

#include "conformance/parts/halting_middleware.h"
#include "support/log/log_record.h"
#include "support/network_test.h"
#include "support/plant.h"

namespace {

using plant::Plant;
using tendon::Channel;
using tendon::ErrorCode;
using tendon::GcmClient;
using tendon::MessageType;
using tendon::Result;
using tendon::Role;
using tendon::message::CallMember;
using tendon::message::CallMemberReply;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr std::chrono::seconds kTestTimeout(120);

/// Records the entries about "looker" in the audit log.
class AuditLog {
 public:
  [[nodiscard]] std::vector<std::string> lines() const {
    std::vector<std::string> lines = log_.texts();
    std::erase_if(lines, [](const std::string& line) {
      return !line.starts_with("looker (") && !line.starts_with("and ");
    });
    return lines;
  }

 private:
  const tendon_test::LogRecord log_{"audit"};
};

/// A process `robot` with a plant, its GCM, and a client of each role.
class GuardedTest : public NetworkTest {
 protected:
  GuardedTest() {
    robot = Start("robot");
    plant = &robot->Add<Plant>("plant");
    EXPECT_TRUE(robot->StartAll().ok());
  }

  [[nodiscard]] std::unique_ptr<GcmClient> Client(Role role) {
    auto client = std::make_unique<GcmClient>(
        NewMiddleware(),
        GcmClient::Options{
            .name = "looker", .address = gcm().address(), .timeout = kTestTimeout, .role = role});
    EXPECT_TRUE(client->WaitUntilWatching().ok());
    EXPECT_TRUE(EventuallyTrue([&] {
      const auto catalogue = client->catalogue();
      const auto& processes = catalogue.processes();
      return processes.contains("robot") && !processes.at("robot").components.empty();
    }));
    return client;
  }

  /// Returns a channel to robot that has sent these bytes as kLowerRole.
  [[nodiscard]] std::shared_ptr<Channel> Lowered(const std::vector<tendon::Bytes>& said) {
    return Lowered(said, *middleware);
  }
  [[nodiscard]] std::shared_ptr<Channel> Lowered(const std::vector<tendon::Bytes>& said,
                                                 tendon::Middleware& way) {
    const auto channel = Channel::Open(way, robot->address(),
                                       {.instance = tendon::os::RandomNumber(),
                                        .name = "looker",
                                        .cookie = *tendon::LoopbackCookie()},
                                       std::make_shared<tendon::ChannelHandler>(), kTestTimeout);
    EXPECT_TRUE(channel.ok()) << channel.error().message;
    for (const tendon::Bytes& body : said) {
      EXPECT_TRUE((*channel)->Notify(tendon::message::kLowerRole, 0, std::span(body)));
    }
    return *channel;
  }
  static Result<CallMemberReply> Stop(Channel& channel) {
    return channel.Call<CallMemberReply>(tendon::message::kCallMember, 0,
                                         CallMember{"plant", "Control", "Stop", {}}, kTestTimeout);
  }

  template <typename T, typename Start>
  static Result<T> Ask(Start start) {
    return tendon::Wait<T>(2 * kTestTimeout, start);
  }

  const AuditLog audit;
  std::unique_ptr<tendon::Process> robot;
  Plant* plant = nullptr;
  std::shared_ptr<tendon::Middleware> middleware = NewMiddleware();
};

template <typename T>
void ExpectDenied(const Result<T>& result, const std::string& act) {
  ASSERT_FALSE(result.ok()) << act;
  EXPECT_EQ(result.error().code, ErrorCode::kDenied) << result.error().message;
  EXPECT_EQ(result.error().message,
            "'" + act +
                "' needs the role operator, but 'looker' is a viewer here: try again as operator");
}

TEST_P(GuardedTest, AGcmDeniesChangesToAViewer) {
  const auto viewer = Client(Role::kViewer);
  const tendon::InterfaceName required("desk", "operator", "Robot");
  const tendon::InterfaceName provided("robot", "plant", "Control");
  using tendon::ConnectionDescription;

  ExpectDenied(
      Ask<ConnectionDescription>([&](auto done) { viewer->Connect(required, provided, done); }),
      "connect");
  ExpectDenied(Ask<ConnectionDescription>([&](auto done) {
                 viewer->Connect(required, provided, done, tendon::WhenConnected::kReplace);
               }),
               "replace a connection");
  ExpectDenied(Ask<void>([&](auto done) { viewer->Disconnect(required, done); }), "disconnect");
  ExpectDenied(Ask<tendon::message::HistoryEntry>([&](auto done) { viewer->Undo(done); }), "undo");
  ExpectDenied(Ask<void>([&](auto done) { viewer->Forget("robot", done); }), "forget a process");
  ExpectDenied(
      Ask<void>([&](auto done) { viewer->SetLogLevel("robot", tendon::LogLevel::kError, done); }),
      "set a log level");

  EXPECT_THAT(audit.lines(),
              Contains(AllOf(testing::StartsWith("looker (viewer, "),
                             HasSubstr("): connect desk/operator/Robot robot/plant/Control: "),
                             testing::EndsWith(": refused"))));
}

TEST_P(GuardedTest, AProcessDeniesCallsToAViewer) {
  const auto viewer = Client(Role::kViewer);

  ExpectDenied(
      Ask<std::string>([&](auto done) { viewer->Call("robot/plant/Control.Stop", "", done); }),
      "call a command");

  EXPECT_EQ(plant->stops.size(), 0U);
  EXPECT_THAT(audit.lines(), Contains(HasSubstr("call a command plant/Control.Stop: refused")));
}

TEST_P(GuardedTest, AViewerMayReadAsMuchAsAnOperator) {
  const auto viewer = Client(Role::kViewer);
  const auto lines = audit.lines();

  const auto history = Ask<tendon::message::History>([&](auto done) { viewer->GetHistory(done); });
  const auto schema = Ask<tendon::Schema>(
      [&](auto done) { viewer->GetSchema("robot", tendon::FingerprintOf<plant::Move>(), done); });

  EXPECT_TRUE(history.ok()) << history.error().message;
  EXPECT_TRUE(schema.ok()) << schema.error().message;
  EXPECT_EQ(audit.lines(), lines);
}

TEST_P(GuardedTest, AnEventListenerMayNotCallFunctions) {
  const auto channel = Lowered({tendon::EncodeBody(static_cast<std::uint8_t>(Role::kViewer))});
  tendon::message::OpenInterface open{.required = {"looker", "events", "Control"},
                                      .provided = {"robot", "plant", "Control"},
                                      .description = {.name = "Control"},
                                      .handle = 1,
                                      .capacity = 16};
  const auto listen = [&] {
    return channel->Call<tendon::message::OpenInterfaceReply>(tendon::message::kListen, 0, open,
                                                              kTestTimeout);
  };

  const auto listened = listen();
  EXPECT_TRUE(listened.ok()) << listened.error().message;
  open.handle = 2;
  open.description.functions = {{.name = "Stop"}};
  const auto refused = listen();

  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kInvalid);
  EXPECT_EQ(
      refused.error().message,
      "the request to listen to the events of robot/plant/Control must not contain functions");
  channel->Close();
}

TEST_P(GuardedTest, AuditsTheActionsOfAnOperator) {
  const auto client = Client(Role::kOperator);

  const auto called =
      Ask<std::string>([&](auto done) { client->Call("robot/plant/Control.Stop", "", done); });

  EXPECT_TRUE(called.ok()) << called.error().message;
  EXPECT_THAT(audit.lines(), Contains(AllOf(testing::StartsWith("looker (operator, "),
                                            HasSubstr("call a command plant/Control.Stop"),
                                            testing::EndsWith(": allowed"))));
}

TEST_P(GuardedTest, ALoweredRoleCannotBeRaised) {
  constexpr auto kViewer = static_cast<std::uint8_t>(Role::kViewer);
  constexpr auto kOperator = static_cast<std::uint8_t>(Role::kOperator);
  const auto channel = Lowered({tendon::EncodeBody(kViewer), tendon::EncodeBody(kOperator)});

  ExpectDenied(Stop(*channel), "call a command");

  channel->Close();
}

TEST_P(GuardedTest, AnInvalidRoleCountsAsTheLowest) {
  for (const tendon::Bytes& nonsense :
       {tendon::Bytes{}, tendon::Bytes{std::byte{200}}, tendon::Bytes(9)}) {
    const auto channel = Lowered({nonsense});
    ExpectDenied(Stop(*channel), "call a command");
    channel->Close();
  }
  const auto operator_still = Lowered({});
  EXPECT_TRUE(Stop(*operator_still).ok());
  operator_still->Close();
}

TEST_P(GuardedTest, DeniesUnlistedMessagesToAll) {
  const auto channel = Lowered({});

  const auto reply = channel->Call(static_cast<MessageType>(0x3ff), 0, {}, kTestTimeout);

  ASSERT_FALSE(reply.ok());
  EXPECT_EQ(reply.error().code, ErrorCode::kDenied);
  EXPECT_EQ(reply.error().message, "message 1023 is not allowed for any role");
  EXPECT_TRUE(Stop(*channel).ok());
  channel->Close();
}

TEST_P(GuardedTest, DeniesALargeMessageAtItsFirstPart) {
  const tendon::Bytes large(3 * tendon::kMaxPieceSize);
  tendon::conformance::HaltingMiddleware way(middleware, 1);
  const tendon::Bytes viewer = tendon::EncodeBody(static_cast<std::uint8_t>(Role::kViewer));
  const auto channel = Lowered({viewer}, way);

  const auto reply =
      channel->Call(tendon::message::kCallMember, 0, large, kTestTimeout, tendon::kOwnLane);

  ExpectDenied(reply, "call a command");
  EXPECT_THAT(audit.lines(), Contains(HasSubstr("call a command: refused")));
  EXPECT_FALSE(Stop(*channel).ok());
  EXPECT_TRUE(channel->is_open());
  channel->Close();
}

TEST_P(GuardedTest, LimitsTheSizeOfViewerMessages) {
  const tendon::Bytes large((std::size_t{1} << 20U) + 1);
  tendon::conformance::HaltingMiddleware way(middleware, 1);
  const auto channel = Lowered({}, way);

  const auto reply =
      channel->Call(tendon::message::kGetSchemas, 0, large, kTestTimeout, tendon::kOwnLane);

  ASSERT_FALSE(reply.ok());
  EXPECT_EQ(reply.error(),
            (tendon::Error{ErrorCode::kInvalid,
                           "'read schemas' accepts messages of at most 1048576 bytes, got "
                           "1048577"}));
  EXPECT_TRUE(Stop(*channel).ok());
  channel->Close();
}

TEST_P(GuardedTest, DeniesNotices) {
  const auto channel = Lowered({tendon::EncodeBody(static_cast<std::uint8_t>(Role::kViewer))});

  EXPECT_TRUE(channel->Notify(static_cast<MessageType>(0x102), 0, tendon::Bytes(8)));

  EXPECT_TRUE(EventuallyTrue([&] {
    for (const std::string& line : audit.lines()) {
      if (line.ends_with("queue commands: refused")) return true;
    }
    return false;
  }));
  channel->Close();
}

TEST_P(GuardedTest, CountsRepeatedDenialsInsteadOfLoggingThem) {
  constexpr int kTimes = 1000;
  const auto channel = Lowered({tendon::EncodeBody(static_cast<std::uint8_t>(Role::kViewer))});

  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < kTimes; ++i) EXPECT_FALSE(Stop(*channel).ok());
  const auto tenths = (std::chrono::steady_clock::now() - begin) / std::chrono::milliseconds(100);
  channel->Close();

  const auto told = [&] {
    std::uint64_t refused = 0;
    std::uint64_t counted = 0;
    for (const std::string& line : audit.lines()) {
      if (line.ends_with(": refused")) ++refused;
      if (line.starts_with("and ")) counted += std::stoull(line.substr(4));
    }
    return std::pair(refused, counted);
  };
  EXPECT_TRUE(EventuallyTrue([&] { return told().first + told().second == kTimes; }))
      << told().first << " and " << told().second;
  EXPECT_LE(told().first, static_cast<std::uint64_t>(50 + 1 + tenths));
}

TEST_P(GuardedTest, AnAuditEntryIsAlwaysOneLine) {
  const auto channel = Lowered({});

  (void)channel->Call<CallMemberReply>(tendon::message::kCallMember, 0,
                                       CallMember{"plant\nrobot: allowed", "C\x1b[2J", "Stop", {}},
                                       kTestTimeout);
  channel->Close();

  EXPECT_THAT(audit.lines(), Contains(HasSubstr("plant\\x0arobot: allowed/C\\x1b[2J.Stop")));
  EXPECT_THAT(audit.lines(), testing::Each(Not(HasSubstr("\n"))));
}

INSTANTIATE_TEST_SUITE_P(Over, GuardedTest, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
