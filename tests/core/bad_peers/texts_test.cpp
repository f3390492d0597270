#include <tendon/base/text.h>
#include <tests/core/gcm/gcm_fixture.h>
#include <tests/support/record.h>

#include <algorithm>
#include <string>

namespace tendon {
namespace {

/// Returns a text that renames a terminal, moves its cursor, loads a picture in a browser, is 1 MB
/// long, and is not UTF-8.
std::string Poison() {
  return "\x1b]0;owned\x07\x1b[2J\n<img src=x onerror=alert(1)><b>bold</b>\xff" +
         std::string(1'000'000, 'x');
}

void ExpectShortAndPrintable(const std::string& text, const std::string& what) {
  EXPECT_FALSE(text.empty()) << what;
  EXPECT_LT(text.size(), 5'000U) << what;
  EXPECT_EQ(text, Printable(text)) << what;
}

void ExpectTame(const std::string& text, const std::string& what) {
  ExpectShortAndPrintable(text, what);
  EXPECT_NE(text.find("\\x1b"), text.npos) << what << " is not what was said";
}

/// Returns a component in which every text is harmful.
ComponentDescription PoisonedArm() {
  ComponentDescription arm = test::Arm();
  arm.class_name = arm.library = arm.fault = Poison();
  for (MemberDescription& command : arm.provided.data()[0].commands) {
    command.in_type = command.out_type = command.hazard = Poison();
  }
  arm.tables.data()[0].columns[0].type = Poison();
  return arm;
}

void ExpectTame(const ComponentDescription& arm) {
  ExpectTame(arm.class_name, "class");
  ExpectTame(arm.library, "library");
  ExpectTame(arm.fault, "fault");
  for (const MemberDescription& command : arm.provided[0].commands) {
    ExpectTame(command.in_type, "type of an argument");
    ExpectTame(command.out_type, "type of an answer");
    ExpectTame(command.hazard, "hazard");
  }
  ExpectTame(arm.tables[0].columns[0].type, "type of a column");
}

/// Records the log that a client receives.
class LogListener final : public test::Recorder {
 public:
  void OnLog(const LogBatch& batch) override {
    for (const message::LogRecord& record : batch.records) records_.Add(record);
  }
  [[nodiscard]] std::vector<message::LogRecord> records() const { return records_.values(); }

 private:
  test::Record<message::LogRecord> records_;
};

class HostileTexts : public test::GcmFixture {};
INSTANTIATE_TEST_SUITE_P(Over, HostileTexts, testing::Values("loopback", "tcp"),
                         test::NameOfParameter);

TEST_P(HostileTexts, ARefusalOfAHugeNameIsPrintable) {
  test::FakeProcess process(NewMiddleware(), Poison());

  const auto joined = process.Join(address_);

  ASSERT_FALSE(joined);
  ExpectShortAndPrintable(joined.error().message, "refusal");
  EXPECT_TRUE(gcm_->catalogue().processes().empty());
}

TEST_P(HostileTexts, DescriptionsOfAMegabyteReachViewersShortAndEscaped) {
  const auto client = Watch();
  const auto robot = Join("robot", {PoisonedArm()});
  robot->Add(PoisonedArm());  // now as a later report

  ASSERT_TRUE(
      EventuallyTrue([&] { return client->catalogue().FindComponent("robot", "arm") != nullptr; }));
  ExpectTame(*client->catalogue().FindComponent("robot", "arm"));
}

TEST_P(HostileTexts, AdvertisedAddressesReachViewersShortAndEscaped) {
  test::FakeProcess robot(NewMiddleware(), "robot");
  robot.Advertise(Poison());

  ASSERT_TRUE(robot.Join(address_));

  ExpectTame(gcm_->catalogue().FindProcess("robot")->process.address, "address");
}

TEST_P(HostileTexts, LogRecordsReachViewersShortAndEscaped) {
  const auto listener = std::make_shared<LogListener>();
  const auto client = Watch(listener);
  client->WatchLog();
  const auto robot = Join("robot", {});

  const std::string shorter = Poison().substr(0, message::kLargestLogBatch / 3);
  EXPECT_TRUE(robot->SendLog({0, {{.source = Poison(), .text = Poison()}}}));
  EXPECT_TRUE(robot->SendLog({1, {{.source = shorter, .text = shorter}}}));

  const auto poisoned = [&] {
    const auto records = listener->records();
    return std::ranges::count_if(
        records, [](const auto& one) { return one.text.find("owned") != one.text.npos; });
  };
  ASSERT_TRUE(EventuallyTrue([&] { return poisoned() == 1; }));
  for (const auto& record : listener->records()) {
    EXPECT_EQ(record.text, Printable(record.text));
    EXPECT_EQ(record.source, Printable(record.source));
    EXPECT_LT(record.text.size(), 5'000U);
    EXPECT_LT(record.source.size(), 500U);
  }
}

/// Refuses every request with a harmful text.
class Refuser final : public ChannelHandler {
 public:
  void OnRequest(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& /*header*/,
                 std::span<const std::byte> /*body*/, Responder responder) override {
    responder.Refuse({ErrorCode::kFailed, Poison()});
  }
};

TEST_P(HostileTexts, AHugeRefusalArrivesShortAndEscaped) {
  const Hello hello{.instance = 1, .name = "robot", .cookie = 7};
  const auto server = NewMiddleware();
  const auto listener = server->Listen(
      "127.0.0.1:0", Channel::Acceptor(hello, [] { return std::make_shared<Refuser>(); }));
  ASSERT_TRUE(listener);
  const auto client = NewMiddleware();
  const auto channel = Channel::Open(*client, (*listener)->address(), hello,
                                     std::make_shared<ChannelHandler>(), kLong);
  ASSERT_TRUE(channel);

  const auto reply = (*channel)->Call(static_cast<MessageType>(0x101), 0, Bytes{}, kLong);

  ASSERT_FALSE(reply);
  ExpectTame(reply.error().message, "refusal");
}

}  // namespace
}  // namespace tendon
