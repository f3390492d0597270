#include <tendon/base/os/process.h>
#include <tendon/gcm/client.h>
#include <tendon/proxy/connection_messages.h>

#include <chrono>
#include <random>
#include <set>
#include <vector>

#include "conformance/resources.h"
#include "core/bad_peers/recording_middleware.h"
#include "core/process/connections/remote_connection.h"
#include "support/machine/sanitized.h"

namespace tendon {
namespace {

constexpr std::chrono::seconds kLongest(20);

struct DeafRows final : RowSink {
  void OnSubscribed(const std::vector<Schema>& /*columns*/) override { is_subscribed = true; }
  void OnRows(const RowBatch& /*batch*/) override {}
  void OnStale(const Error& /*reason*/) override {}
  std::atomic<bool> is_subscribed{false};
};

struct DeafEvents final : EventSink {
  void OnListening(const std::vector<MemberDescription>& /*events*/) override {
    is_listening = true;
  }
  void OnEvent(std::size_t /*event*/, std::span<const std::byte> /*value*/,
               const EventTime& /*time*/) override {}
  void OnEventsLost(std::size_t /*event*/, std::uint64_t /*lost*/) override {}
  void OnStale(const Error& /*reason*/) override {}
  std::atomic<bool> is_listening{false};
};

/// Valid frames in which some bytes of the body or the recipient were changed. The changes are the
/// same in every run.
class FrameMutants {
 public:
  explicit FrameMutants(std::vector<Bytes> right) : right_(std::move(right)) {}

  Bytes Next() {
    Bytes mutant = right_[random_() % right_.size()];
    FrameHeader header = *ReadWholeFrame(mutant);
    if (random_() % 8 == 0) header.handle = random_() % 16;
    if (random_() % 8 == 0) mutant.resize(FrameHeader::kSize + random_() % (header.size + 1));
    header.size = static_cast<std::uint32_t>(mutant.size() - FrameHeader::kSize);
    for (unsigned changes = 1 + random_() % 4U; header.size > 0 && changes > 0; --changes) {
      mutant[FrameHeader::kSize + random_() % header.size] = static_cast<std::byte>(random_());
    }
    WriteHeader(header, std::span(mutant).first<FrameHeader::kSize>());
    return mutant;
  }

 private:
  std::mt19937 random_{4711};
  const std::vector<Bytes> right_;
};

/// Two processes and a viewer that have exchanged all kinds of messages, and a program that has
/// recorded the messages.
class MutantMessages : public RemoteConnection {
 protected:
  void SetUp() override {
    StartRobot();
    ProcessOptions options = Options();
    options.middleware = recorder;
    gcm_address = options.gcm;
    desk = std::make_unique<Process>("desk", options);
    ASSERT_TRUE(desk->WaitUntilJoined(kLongest).ok());
    user = &desk->Add<plant::Operator>("operator");
    ASSERT_TRUE(desk->StartAll().ok());
    viewer = std::make_unique<GcmClient>(
        recorder, GcmClient::Options{.address = gcm_address, .timeout = kLongest});
    ASSERT_TRUE(viewer->WaitUntilWatching().ok());
    Connect();
    Operate();
    Look();
  }
  void TearDown() override { viewer.reset(); }

  void Operate() const {
    EXPECT_TRUE(user->stop());
    EXPECT_EQ(user->move_to.Wait({}, kLongest), Status(Status::kDone));
    plant::Move move;
    EXPECT_TRUE(EventuallyTrue([&] { return user->get_move(move) == Status(Status::kDone); }));
    EXPECT_TRUE(
        EventuallyTrue([&] { return user->get_scaled(2.0, move) == Status(Status::kDone); }));
    plant::Note note{.text = "note", .values = {1, 2, 3}};
    EXPECT_EQ(user->write.Wait(note, kLongest), Status(Status::kDone));
  }
  void Look() const {
    const message::ConnectionEnds ends{.required = kRobot, .provided = kControl};
    const auto rows = std::make_shared<DeafRows>();
    const auto events = std::make_shared<DeafEvents>();
    const auto subscription =
        viewer->telemetry().Subscribe({"robot", "plant", "state", {"Move"}}, rows);
    const auto listener = viewer->Listen({kControl, {"Moved"}}, events);
    EXPECT_TRUE(EventuallyTrue([&] { return rows->is_subscribed && events->is_listening; }));
    viewer->WatchLog();
    EXPECT_TRUE(Did<message::History>([&](auto done) { viewer->GetHistory(done); }));
    EXPECT_TRUE(Did<message::SystemHealth>([&](auto done) { viewer->GetHealth(done); }));
    EXPECT_TRUE(Did<message::Classes>([&](auto done) { viewer->GetClasses("robot", done); }));
    EXPECT_TRUE(Did<ConnectionCounts>([&](auto done) { viewer->GetCounts(kRobot, done); }));
    EXPECT_TRUE(Did<ConnectionCounts>([&](auto done) { viewer->GetProviderCounts(ends, done); }));
    EXPECT_TRUE(Did<MailboxFill>([&](auto done) { viewer->GetFill("robot", "plant", done); }));
    EXPECT_TRUE(Did<std::string>(
        [&](auto done) { viewer->Call("robot/plant/Control.GetMove", "", done); }));
    EXPECT_TRUE(Did<Schema>(
        [&](auto done) { viewer->GetSchema("robot", FingerprintOf<plant::Note>(), done); }));
    EXPECT_TRUE(Did<void>([&](auto done) { viewer->SetLogLevel("robot", LogLevel::kInfo, done); }));
    EXPECT_TRUE(Did<void>([&](auto done) { viewer->Disconnect(kRobot, done); }));
    EXPECT_TRUE(
        Did<ConnectionDescription>([&](auto done) { viewer->Connect(kRobot, kControl, done); }));
    viewer->StopListening(listener);
    viewer->telemetry().Unsubscribe(subscription);
  }
  template <typename T, typename Start>
  static bool Did(Start start) {
    const auto reply = Wait<T>(kLongest, start);
    EXPECT_TRUE(reply.ok()) << reply.error().message;
    return reply.ok();
  }

  /// Returns the recorded messages, except for messages of the channel itself: a channel closes
  /// after a wrong one.
  std::vector<Bytes> MessagesTo(const std::string& address) const {
    auto frames = recorder->FramesTo(address);
    std::erase_if(frames, [](const Bytes& frame) {
      return ReadWholeFrame(frame)->type < message::kOpenInterface;
    });
    return frames;
  }

  /// Sends mutants over channels of an admitted program. Each channel sends as many as the peer
  /// accepts.
  void Say(FrameMutants& mutants, const std::string& address, int count) {
    constexpr int kOnOne = 500;
    while (count > 0) {
      const auto channel = Open(address);
      ASSERT_NE(channel, nullptr);
      for (int said = 0; said < kOnOne && count > 0 && channel->is_open(); ++said, --count) {
        const Bytes frame = mutants.Next();
        const FrameHeader header = *ReadWholeFrame(frame);
        const auto body = std::span(frame).subspan(FrameHeader::kSize);
        if (header.request == 0) {
          (void)channel->Notify(header.type, header.handle, body);
        } else {
          channel->Request(header.type, header.handle, body, kLongest, [](const auto&) {});
        }
      }
      // Whatever the reply is, all earlier messages have been read.
      (void)channel->Call(message::kPing, 0, EncodeBody(None{}), kLongest);
      channel->Close();
    }
  }
  std::shared_ptr<Channel> Open(const std::string& address) {
    auto opened = Channel::Open(
        *middleware, address,
        {.instance = os::RandomNumber(), .name = "mutant", .cookie = *LoopbackCookie()},
        std::make_shared<ChannelHandler>(), kLongest);
    EXPECT_TRUE(opened.ok()) << opened.error().message;
    return opened ? *opened : nullptr;
  }

  /// Expects that the processes are connected, if necessary again, and serve a viewer.
  void ExpectSoundness() {
    EXPECT_TRUE(EventuallyTrue([this] {
      if (desk->connections().empty()) (void)desk->Connect(kRobot, kControl);
      return user->move_to.Wait({}, std::chrono::seconds(1)) == Status(Status::kDone);
    }));
    EXPECT_TRUE(Did<message::SystemHealth>([&](auto done) { viewer->GetHealth(done); }));
    EXPECT_TRUE(Did<std::string>(
        [&](auto done) { viewer->Call("robot/plant/Control.GetMove", "", done); }));
  }

  std::shared_ptr<test::RecordingMiddleware> recorder =
      std::make_shared<test::RecordingMiddleware>(NewMiddleware());
  std::shared_ptr<Middleware> middleware = NewMiddleware();
  std::string gcm_address;
  std::unique_ptr<GcmClient> viewer;
};

const int kMutants = test::IsSanitized() ? 1'000 : 10'000;
/// The allowed growth of memory when the same number of mutants is sent again.
constexpr std::size_t kFlat = std::size_t{16} << 20U;

void ExpectTypes(const std::vector<Bytes>& frames, std::size_t least) {
  std::set<MessageType> types;
  for (const Bytes& frame : frames) types.insert(ReadWholeFrame(frame)->type);
  EXPECT_GE(types.size(), least);
}

TEST_P(MutantMessages, AProcessSurvivesThemFromAnAdmittedPeer) {
  const auto frames = MessagesTo(robot->address());
  ExpectTypes(frames, 12);
  FrameMutants mutants(frames);
  Say(mutants, robot->address(), kMutants);
  const std::size_t before = conformance::MemoryInUse();

  Say(mutants, robot->address(), kMutants);

  EXPECT_TRUE(EventuallyTrue([&] { return conformance::MemoryInUse() < before + kFlat; }));
  ExpectSoundness();
}

TEST_P(MutantMessages, TheGcmSurvivesThemFromAnAdmittedPeer) {
  const auto frames = MessagesTo(gcm_address);
  ExpectTypes(frames, 10);
  FrameMutants mutants(frames);
  Say(mutants, gcm_address, kMutants);
  const std::size_t before = conformance::MemoryInUse();

  Say(mutants, gcm_address, kMutants);

  EXPECT_TRUE(EventuallyTrue([&] { return conformance::MemoryInUse() < before + kFlat; }));
  ExpectSoundness();
}

INSTANTIATE_TEST_SUITE_P(Over, MutantMessages, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
}  // namespace tendon
