#include <gmock/gmock.h>
#include <tests/core/gcm/gcm_fixture.h>
#include <tests/support/log/log_record.h>
#include <tests/support/peers/impostor.h>

namespace tendon {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using test::FakeProcess;
using test::Impostor;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A robot, and other programs that know its session.
class Impostors : public test::GcmFixture {
 protected:
  void SetUp() override {
    const auto joined = robot_.Join(address_);
    ASSERT_TRUE(joined) << joined.error().message;
    session_ = joined->session;
  }

  /// Opens a channel with the robot's session.
  std::shared_ptr<Channel> OpenAs(const std::string& name, std::uint64_t instance = 7) {
    const Hello hello{
        .instance = instance, .name = name, .session = session_, .cookie = *LoopbackCookie()};
    const auto channel =
        Channel::Open(*thiefs_, address_, hello, std::make_shared<ChannelHandler>(), kLong);
    EXPECT_TRUE(channel) << channel.error().message;
    return channel ? *channel : nullptr;
  }
  static Result<message::JoinReply> JoinAsRobot(Channel& channel, std::uint64_t instance = 7) {
    const message::Join join{.process = {.name = "robot", .instance = instance}};
    return channel.Call<message::JoinReply>(message::kJoin, 0, join, kLong);
  }
  static Result<None> Ask(Channel& channel, MessageType type) {
    return channel.Call<None>(type, 0, None{}, kLong);
  }

  FakeProcess robot_{NewMiddleware(), "robot"};
  const std::shared_ptr<Middleware> thiefs_ = NewMiddleware();
  std::uint64_t session_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Over, Impostors, testing::Values("loopback", "tcp"),
                         test::NameOfParameter);

TEST_P(Impostors, AStolenSessionDoesNotRenewALease) {
  const auto thief = OpenAs("robot");

  for (int i = 0; i < 4; ++i) {
    Pass(400ms);
    EXPECT_TRUE(Ask(*thief, message::kRenew)) << "it asks whether the GCM lives, as viewers do";
  }

  EXPECT_EQ(StateOf("robot"), ProcessState::kLost);
  EXPECT_FALSE(robot_.Renew());
}

TEST_P(Impostors, AStolenSessionCannotReportOrLeave) {
  const auto thief = OpenAs("robot");
  const message::Report report{
      .changes = {{.kind = CatalogueChange::Kind::kComponent, .components = {test::Arm()}}}};

  EXPECT_TRUE(thief->Notify(message::kReport, 0, report));
  const auto told =
      thief->Call<message::GcmClock>(message::kReportHealth, 0, message::Health{}, kLong);
  ASSERT_FALSE(told);
  EXPECT_EQ(told.error().code, ErrorCode::kDenied);
  (void)Ask(*thief, message::kLeave);

  EXPECT_EQ(StateOf("robot"), ProcessState::kAlive);
  EXPECT_EQ(gcm_->catalogue().FindComponent("robot", "arm"), nullptr);
  EXPECT_TRUE(robot_.Renew());
}

TEST_P(Impostors, AStolenNameOrSessionCannotJoin) {
  const std::uint64_t instance = robot_.description().instance;
  const auto thief = OpenAs("thief", instance);
  const auto other = OpenAs("robot");
  const tendon_test::LogRecord audit("audit");

  const auto by_name = JoinAsRobot(*thief, instance);
  const auto by_session = JoinAsRobot(*other);

  ASSERT_FALSE(by_name);
  EXPECT_EQ(by_name.error().code, ErrorCode::kDenied);
  EXPECT_THAT(by_name.error().message, HasSubstr("'thief' cannot join as process 'robot'"));
  ASSERT_FALSE(by_session);
  EXPECT_EQ(by_session.error().code, ErrorCode::kExists);
  EXPECT_THAT(by_session.error().message, HasSubstr("process name 'robot' is in use by host"));
  EXPECT_THAT(audit.texts(), Contains(StartsWith("thief (operator, ")));
  EXPECT_THAT(audit.texts(), Contains(HasSubstr("): join as 'robot': refused")));
  EXPECT_THAT(audit.texts(),
              Contains(HasSubstr("): join: refused: process name 'robot' is in use by host")));
  EXPECT_THAT(audit.texts(), Not(Contains(HasSubstr("allowed"))));
  EXPECT_TRUE(robot_.Renew());
}

/// The GCM sends orders to a process only over the link that the process has opened.
TEST_P(Impostors, TheGcmNeverCallsAnAdvertisedAddress) {
  const Impostor third(NewMiddleware(), "arm");
  FakeProcess arm(NewMiddleware(), "arm");
  arm.Advertise(third.address());
  arm.Add(test::Arm());
  ASSERT_TRUE(arm.Join(address_));
  const auto desk = Join("desk", {test::Teleoperation()});
  const auto client = Watch();
  const InterfaceName provided("arm", "arm", "Control");

  ASSERT_TRUE(Connect(*client, test::kRobot, provided));
  ASSERT_TRUE(Disconnect(*client));
  ASSERT_TRUE(Undo(*client));
  for (const std::string process : {"arm", "desk"}) {
    (void)Wait<message::Classes>(
        kLong, [&](auto handler) { client->GetClasses(process, std::move(handler)); });
    (void)Wait<void>(kLong, [&](auto handler) {
      client->SetLogLevel(process, LogLevel::kInfo, std::move(handler));
    });
  }

  EXPECT_EQ(third.links(), 0);
  ASSERT_FALSE(desk->orders().empty());
  EXPECT_EQ(desk->orders().front().address, third.address());
}

TEST_P(Impostors, AnImpostorAtAnAddressReceivesOnlyAHello) {
  const Impostor third(NewMiddleware(), "arm");
  FakeProcess arm(NewMiddleware(), "arm");
  arm.Advertise(third.address());
  arm.Add(test::Arm());
  ASSERT_TRUE(arm.Join(address_));
  const auto client = Watch();

  const auto fill = Wait<MailboxFill>(
      kLong, [&](auto handler) { client->GetFill("arm", "arm", std::move(handler)); });

  ASSERT_FALSE(fill);
  EXPECT_EQ(fill.error().code, ErrorCode::kDenied);
  EXPECT_THAT(fill.error().message, HasSubstr("process 'arm' does not answer at " +
                                              third.address() + ": arm does not know "));
  EXPECT_THAT(third.heard(), ElementsAre(MessageType::kHello));
}

}  // namespace
}  // namespace tendon
