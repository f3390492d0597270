#include <gmock/gmock.h>
#include <tendon/interface/observed_call.h>
#include <tendon/payload/codec.h>
#include <tendon/process/process.h>
#include <tendon/task/periodic_task.h>
#include <tests/core/gcm/gcm_fixture.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "support/allocation_guard.h"

namespace tendon {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using testing::HasSubstr;

/// Executes calls, and must not allocate for it, whether they are observed or not.
class Drum final : public PeriodicTask {
 public:
  explicit Drum(std::string name) : PeriodicTask(std::move(name), 1ms) {
    state_table().Add(beats_in_all_, "Beats");
    auto& control = AddProvidedInterface("Control");
    control.AddCommandWrite(&Drum::Beat, this, "Beat");
    control.AddCommandReadState(state_table(), beats_in_all_, "GetBeats");
  }
  ~Drum() override { Join(); }

  void Run() override {
    const AllocationGuard guard;
    ProcessQueuedCommands();
  }
  [[nodiscard]] std::uint64_t beats() const { return beats_.load(); }

 private:
  void Beat(std::uint64_t /*number*/) { ++beats_; }

  std::uint64_t beats_in_all_ = 0;
  std::atomic<std::uint64_t> beats_{0};
};

class Drummer final : public Component {
 public:
  explicit Drummer(std::string name) : Component(std::move(name)) {
    auto& drum = AddRequiredInterface("Drum");
    drum.SetMailboxCapacity(256);
    drum.AddFunction(beat, "Beat");
  }

  WriteFunction<std::uint64_t> beat;
};

/// Counts the calls that it sees, and those that it is told are lost.
class Witness final : public EventSink {
 public:
  void OnListening(const std::vector<MemberDescription>& events) override {
    const std::scoped_lock lock(mutex_);
    listening_ = events;
  }
  void OnEvent(std::size_t /*event*/, std::span<const std::byte> value,
               const EventTime& time) override {
    const std::scoped_lock lock(mutex_);
    const CallHeader header = HeaderOfCall(value);
    EXPECT_LE(time.raised, SteadyClock().Now());
    if (header.outcome != CallOutcome::kExecuted) {
      ++refused_;
      return;
    }
    std::uint64_t number = 0;
    EXPECT_TRUE(Decode(value.subspan(kEncodedSize<CallHeader>).first(sizeof number), number));
    EXPECT_TRUE(executed_ == 0 || number > last_) << "each call once, in order";
    last_ = number;
    ++executed_;
  }
  void OnEventsLost(std::size_t /*event*/, std::uint64_t lost) override {
    const std::scoped_lock lock(mutex_);
    lost_ += lost;
  }
  void OnStale(const Error& reason) override {
    const std::scoped_lock lock(mutex_);
    complaint_ = reason.message;
  }

  [[nodiscard]] std::vector<MemberDescription> listening() const {
    const std::scoped_lock lock(mutex_);
    return listening_;
  }
  [[nodiscard]] std::uint64_t executed() const {
    const std::scoped_lock lock(mutex_);
    return executed_;
  }
  [[nodiscard]] std::uint64_t all() const {
    const std::scoped_lock lock(mutex_);
    return executed_ + refused_ + lost_;
  }
  [[nodiscard]] std::string complaint() const {
    const std::scoped_lock lock(mutex_);
    return complaint_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<MemberDescription> listening_;
  std::uint64_t executed_ = 0;
  std::uint64_t refused_ = 0;
  std::uint64_t lost_ = 0;
  std::uint64_t last_ = 0;
  std::string complaint_;
};

class ObservedCommands : public test::GcmFixture {
 protected:
  void SetUp() override {
    StartBand();
    client_ = Watch();
    ASSERT_TRUE(EventuallyTrue(
        [&] { return client_->catalogue().FindComponent("band", "drum") != nullptr; }));
  }
  void StartBand() {
    band_ = std::make_unique<Process>(
        "band", ProcessOptions{.middleware = NewMiddleware(), .gcm = address_});
    drum_ = &band_->Add<Drum>("drum");
    drummer_ = &band_->Add<Drummer>("drummer");
    ASSERT_TRUE(band_->Connect({"drummer", "Drum"}, {"drum", "Control"}));
    ASSERT_TRUE(band_->StartAll());
  }
  void Listen(std::uint32_t capacity = 1024) {
    client_->Listen({.provided = {"band", "drum", "Control"},
                     .events = {},
                     .commands = {"Beat"},
                     .capacity = capacity},
                    witness_);
    ASSERT_TRUE(EventuallyTrue([&] { return !witness_->listening().empty(); }))
        << witness_->complaint();
  }
  /// Returns how many calls were refused.
  std::uint64_t Beat(std::uint64_t calls) {
    std::uint64_t refused = 0;
    for (std::uint64_t i = 1; i <= calls; ++i) {
      while (!drummer_->beat(++number_)) {
        ++refused;
        std::this_thread::yield();
      }
    }
    return refused;
  }

  std::unique_ptr<Process> band_;
  Drum* drum_ = nullptr;
  Drummer* drummer_ = nullptr;
  std::uint64_t number_ = 0;
  std::unique_ptr<GcmClient> client_;
  const std::shared_ptr<Witness> witness_ = std::make_shared<Witness>();
};

INSTANTIATE_TEST_SUITE_P(Over, ObservedCommands, testing::Values("loopback", "tcp"),
                         test::NameOfParameter);

TEST_P(ObservedCommands, ReachAViewer) {
  Listen();
  EXPECT_EQ(witness_->listening().at(0).signature.in, FingerprintOf<std::uint64_t>());

  Beat(100);

  EXPECT_TRUE(EventuallyTrue([&] { return witness_->all() >= 100; }));
  EXPECT_EQ(drum_->beats(), 100U);
}

TEST_P(ObservedCommands, AreSeenOnceOrCountedAsLost) {
  constexpr std::uint64_t kCalls = 20'000;
  constexpr std::uint32_t kFew = 8;
  Listen(kFew);

  const std::uint64_t refused = Beat(kCalls);

  EXPECT_TRUE(EventuallyTrue([&] { return witness_->all() >= kCalls + refused; }))
      << witness_->all() << " of " << kCalls + refused;
  EXPECT_TRUE(EventuallyTrue([&] { return drum_->beats() == kCalls; }));
  EXPECT_EQ(witness_->all(), kCalls + refused);
}

TEST_P(ObservedCommands, AreNotSentAfterTheViewerHasGone) {
  Listen();
  client_.reset();

  ASSERT_TRUE(EventuallyTrue([&] {
    Beat(1);
    return !drum_->FindProvided("Control")->FindCommand("Beat")->is_observed();
  }));
  const std::uint64_t seen = witness_->all();
  Beat(10);

  EXPECT_TRUE(EventuallyTrue([&] { return drum_->beats() == number_; }));
  EXPECT_EQ(witness_->all(), seen);
}

TEST_P(ObservedCommands, AreSeenAgainAfterARestartOfTheProcess) {
  Listen();
  band_.reset();
  ASSERT_TRUE(EventuallyTrue([&] { return !witness_->complaint().empty(); }));

  StartBand();

  const std::uint64_t before = witness_->executed();
  EXPECT_TRUE(EventuallyTrue([&] {
    Beat(1);
    return witness_->executed() > before;
  }));
}

TEST_P(ObservedCommands, AreRefusedForReadsAndForNamesThatDoNotExist) {
  client_->Listen({.provided = {"band", "drum", "Control"}, .events = {}, .commands = {"GetBeats"}},
                  witness_);
  ASSERT_TRUE(EventuallyTrue([&] { return !witness_->complaint().empty(); }));
  EXPECT_THAT(witness_->complaint(), HasSubstr("band/drum/Control.GetBeats is a read command"));

  const auto other = std::make_shared<Witness>();
  client_->Listen({.provided = {"band", "drum", "Control"}, .events = {}, .commands = {"Beet"}},
                  other);
  ASSERT_TRUE(EventuallyTrue([&] { return !other->complaint().empty(); }));
  EXPECT_EQ(other->complaint(), "there is no command band/drum/Control.Beet");
}

}  // namespace
}  // namespace tendon
