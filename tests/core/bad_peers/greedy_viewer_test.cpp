#include <gmock/gmock.h>
#include <tendon/middleware/channel.h>
#include <tendon/middleware/channel_handler.h>
#include <tendon/process/viewer_messages.h>
#include <tendon/proxy/connection_messages.h>
#include <tendon/task/periodic_task.h>

#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/process/telemetry/viewing.h"
#include "support/wait.h"

namespace {

/// Eight values of one type. Nested several times, it becomes a type with a very long schema.
template <typename T>
struct Eight {
  T a{}, b{}, c{}, d{}, e{}, f{}, g{}, h{};
};
using Words = Eight<std::uint8_t>;
using Pages = Eight<Words>;
using Book = Eight<Pages>;

template <typename T>
consteval auto DescribeEight(std::string_view name) {
  constexpr std::string_view kHelp =
      "At length, as somebody has found out who wanted to know, and to say so in all of its parts, "
      "where it will be read over and over again.";
  using tendon::Field;
  using E = Eight<T>;
  return tendon::Describe(name, Field{"a", &E::a}.Help(kHelp), Field{"b", &E::b}.Help(kHelp),
                          Field{"c", &E::c}.Help(kHelp), Field{"d", &E::d}.Help(kHelp),
                          Field{"e", &E::e}.Help(kHelp), Field{"f", &E::f}.Help(kHelp),
                          Field{"g", &E::g}.Help(kHelp), Field{"h", &E::h}.Help(kHelp));
}

}  // namespace

template <>
inline constexpr auto tendon::kPayload<Words> = DescribeEight<std::uint8_t>("test.Words");
template <>
inline constexpr auto tendon::kPayload<Pages> = DescribeEight<Words>("test.Pages");
template <>
inline constexpr auto tendon::kPayload<Book> = DescribeEight<Pages>("test.Book");

namespace {

using namespace std::chrono_literals;
using tendon::Bytes;
using tendon::Channel;
using tendon::ErrorCode;
using tendon::Result;
using tendon::RowDelivery;
using testing::HasSubstr;
namespace message = tendon::message;

constexpr auto kLong = 60s;
constexpr std::size_t kMaxSubscriptions = 2048;  // maximum for one viewer
constexpr std::size_t kMaxReadings = 32;  // maximum for one viewer, with all columns of a table

/// Writes a row of two columns each millisecond. Clients can mirror its reads.
class Meter final : public tendon::PeriodicTask {
 public:
  explicit Meter(std::string name) : PeriodicTask(std::move(name), 1ms) {
    auto& table = AddStateTable("level");
    table.Add(level_, "Level");
    table.Add(slope_, "Slope");
    auto& control = AddProvidedInterface("Level");
    control.AddCommandReadState(table, level_, "GetLevel");
    control.AddCommandReadState(table, slope_, "GetSlope");
  }
  ~Meter() override { Join(); }
  void Run() override { level_ += 1.0; }

 private:
  double level_ = 0.0;
  double slope_ = 0.0;
};

/// Has so many columns that their schemas do not fit into one message.
class Library final : public tendon::PeriodicTask {
 public:
  explicit Library(std::string name) : PeriodicTask(std::move(name), 50ms) {
    auto& table = AddStateTable("books");
    for (std::size_t i = 0; i < books_.size(); ++i) {
      names.push_back("Book" + std::to_string(i));
      table.Add(books_.at(i), names.back());
    }
  }
  ~Library() override { Join(); }
  void Run() override {}

  std::vector<std::string> names;

 private:
  std::array<Book, 800> books_{};
};

/// Records for which subscriptions rows have arrived.
class Listener final : public tendon::ChannelHandler {
 public:
  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const tendon::FrameHeader& header,
                std::span<const std::byte> /*body*/) override {
    if (header.type != message::kRows) return;
    const std::scoped_lock lock(mutex_);
    handles_.insert(header.handle);
    ++batches_;
  }
  [[nodiscard]] std::set<std::uint32_t> handles() const {
    const std::scoped_lock lock(mutex_);
    return handles_;
  }
  [[nodiscard]] std::size_t batches() const {
    const std::scoped_lock lock(mutex_);
    return batches_;
  }

 private:
  mutable std::mutex mutex_;
  std::set<std::uint32_t> handles_;
  std::size_t batches_ = 0;
};

/// A viewer that requests more than a viewer could need, over its own channel.
class Viewer {
 public:
  Viewer(std::shared_ptr<tendon::Middleware> middleware, const std::string& process)
      : middleware_(std::move(middleware)) {
    const auto cookie = tendon::LoopbackCookie();
    EXPECT_TRUE(cookie.ok());
    const tendon::Hello hello{
        .instance = tendon::os::RandomNumber(), .name = "viewer", .cookie = *cookie};
    auto opened = Channel::Open(*middleware_, process, hello, listener, kLong);
    EXPECT_TRUE(opened.ok());
    channel_ = *std::move(opened);
  }
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;
  ~Viewer() { channel_->Close(); }

  Result<message::SubscribeReply> Subscribe(const message::Subscribe& wanted) {
    return channel_->Call<message::SubscribeReply>(message::kSubscribe, 0, wanted, kLong);
  }
  Result<message::MirrorReply> Mirror(const message::Mirror& wanted) {
    return channel_->Call<message::MirrorReply>(message::kMirror, 0, wanted, kLong);
  }
  /// Sends a subscription, and does not wait for the reply.
  void Ask(const message::Subscribe& wanted,
           const std::function<void(Result<message::SubscribeReply>)>& hear) {
    channel_->Request<message::SubscribeReply>(message::kSubscribe, 0, wanted, kLong, hear);
  }
  /// Requests an interface that does not exist, and does not wait for the reply.
  void AskToOpen(const std::function<void(Result<message::OpenInterfaceReply>)>& hear) {
    const message::OpenInterface open{.provided = {"robot", "meter", "None"}};
    channel_->Request<message::OpenInterfaceReply>(message::kOpenInterface, 0, open, kLong, hear);
  }
  [[nodiscard]] bool is_open() const { return channel_->is_open(); }
  /// Returns true if the message could be sent.
  bool CloseAny() { return bool(channel_->Notify(message::kCloseInterface, 0, Bytes())); }
  void Unsubscribe(std::uint32_t handle) {
    EXPECT_TRUE(channel_->Notify(message::kUnsubscribe, handle, Bytes()));
  }

  const std::shared_ptr<Listener> listener = std::make_shared<Listener>();

 private:
  const std::shared_ptr<tendon::Middleware> middleware_;
  std::shared_ptr<Channel> channel_;
};

/// While the lock exists, the process executes no request that concerns its components.
std::unique_lock<std::recursive_mutex> HoldUp(const tendon::Process& process) {
  struct Opened : tendon::LocalManager {
    using LocalManager::Lock;
  };
  return (process.*(&Opened::Lock))();
}

class GreedyViewer : public ViewingTest {
 protected:
  GreedyViewer() : robot(Start("robot")) {
    robot->Add<Meter>("meter");
    EXPECT_TRUE(robot->StartAll().ok());
  }

  static message::Subscribe Wanting(std::vector<std::string> columns, tendon::RowChoice rows = {}) {
    return {
        .component = "meter", .table = "state-level", .columns = std::move(columns), .rows = rows};
  }
  /// Returns a subscription to the newest row. A viewer that acknowledges nothing gets only one
  /// row.
  static message::Subscribe WantingNewest() {
    return Wanting({"Level"}, {.delivery = RowDelivery::kNewest});
  }
  /// Returns a subscription with a unique period, determined by the number.
  static message::Subscribe WantingEach(std::size_t period) {
    return Wanting({"Level"}, {.period = 1s + std::chrono::nanoseconds(period)});
  }

  std::unique_ptr<tendon::Process> robot;
  Viewer greedy{NewMiddleware(), robot->address()};
  Viewer modest{NewMiddleware(), robot->address()};
};

TEST_P(GreedyViewer, NamingAColumnTwiceIsRefused) {
  const auto refused = greedy.Subscribe(Wanting({"Level", "Slope", "Level"}));

  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kInvalid);
  EXPECT_THAT(refused.error().message, HasSubstr("robot/meter/state-level names column 'Level' "
                                                 "twice"));
}

TEST_P(GreedyViewer, NamingAColumnThousandsOfTimesDelaysNoOtherViewer) {
  ASSERT_TRUE(modest.Subscribe(Wanting({"Level"})).ok());

  const auto refused = greedy.Subscribe(Wanting(std::vector<std::string>(60'000, "Level")));

  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().message, HasSubstr("names column 'Level' twice"));
  const std::size_t before = modest.listener->batches();
  EXPECT_TRUE(EventuallyTrue([&] { return modest.listener->batches() > before + 10; }));
}

TEST_P(GreedyViewer, MirroringACommandTwiceIsRefused) {
  const tendon::InterfaceName level("robot", "meter", "Level");

  const auto refused = greedy.Mirror({level, {"GetLevel", "GetSlope", "GetLevel"}});

  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kInvalid);
  EXPECT_THAT(refused.error().message, HasSubstr("robot/meter/Level names 'GetLevel' twice"));
}

TEST_P(GreedyViewer, LimitsTheNumberOfSubscriptions) {
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < kMaxSubscriptions; ++i) {
    const auto subscribed = greedy.Subscribe(WantingNewest());
    ASSERT_TRUE(subscribed.ok()) << "at " << i << ": " << subscribed.error().message;
    last = subscribed->handle;
  }

  const auto refused = greedy.Subscribe(WantingNewest());
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kFailed);
  EXPECT_THAT(refused.error().message, HasSubstr("2048 subscriptions"));
  EXPECT_TRUE(modest.Subscribe(WantingNewest()).ok());

  greedy.Unsubscribe(last);
  EXPECT_TRUE(greedy.Subscribe(WantingNewest()).ok());
}

TEST_P(GreedyViewer, LimitsTheNumberOfReadingsPerColumn) {
  constexpr std::size_t kColumns = 2;
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < kMaxReadings * kColumns; ++i) {
    const auto subscribed = greedy.Subscribe(WantingEach(i));
    ASSERT_TRUE(subscribed.ok()) << "at " << i << ": " << subscribed.error().message;
    last = subscribed->handle;
  }

  const auto refused = greedy.Subscribe(WantingEach(10'000));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kFailed);
  EXPECT_THAT(refused.error().message, HasSubstr("robot/meter/state-level"));
  EXPECT_TRUE(greedy.Subscribe(WantingEach(0)).ok()) << "it is read already";
  EXPECT_TRUE(modest.Subscribe(WantingEach(10'000)).ok());
  EXPECT_FALSE(greedy.Subscribe(WantingEach(20'000)).ok());

  greedy.Unsubscribe(last);
  EXPECT_TRUE(greedy.Subscribe(WantingEach(20'000)).ok());
}

TEST_P(GreedyViewer, MaySubscribeToSingleAndAllColumns) {
  for (const char* column : {"Level", "Slope"}) {
    EXPECT_TRUE(greedy.Subscribe(Wanting({column})).ok());
  }

  EXPECT_TRUE(greedy.Subscribe(Wanting({"Level", "Slope"})).ok());
  EXPECT_TRUE(greedy.Subscribe(Wanting({})).ok());
}

TEST_P(GreedyViewer, AnUnsendableReplyLeavesNoSubscription) {
  const auto& library = robot->Add<Library>("library");
  ASSERT_TRUE(robot->StartAll().ok());

  const auto refused =
      greedy.Subscribe({.component = "library", .table = "state-books", .columns = library.names});
  const auto subscribed = greedy.Subscribe(
      {.component = "library", .table = "state-books", .columns = {library.names.front()}});

  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().message, HasSubstr("exceeds max_payload"));
  ASSERT_TRUE(subscribed.ok()) << subscribed.error().message;
  EXPECT_TRUE(EventuallyTrue([&] { return greedy.listener->batches() > 10; }));
  EXPECT_EQ(greedy.listener->handles(), std::set{subscribed->handle});
}

TEST_P(GreedyViewer, RefusesRequestsFasterThanTheyAreServed) {
  constexpr int kMany = 100'000;
  // Shared with the callbacks, which may still be called after the test body has returned.
  const auto refused = std::make_shared<std::atomic<int>>(0);
  const auto hear = [refused](const Result<message::SubscribeReply>& reply) {
    constexpr std::string_view kWhy = "keeps at most 8192 waiting requests";
    if (!reply && reply.error().message.find(kWhy) != std::string::npos) ++*refused;
  };

  auto held = HoldUp(*robot);
  for (int asked = 0; asked < kMany && *refused == 0; ++asked) greedy.Ask(WantingNewest(), hear);
  EXPECT_TRUE(EventuallyTrue([&] { return *refused > 0; }));
  held.unlock();

  EXPECT_TRUE(modest.Subscribe(WantingNewest()).ok());
}

TEST_P(GreedyViewer, RefusesOpeningInterfacesFasterThanServed) {
  constexpr int kMany = 100'000;
  // Shared with the callbacks, which may still be called after the test body has returned.
  const auto refused = std::make_shared<std::atomic<int>>(0);
  const auto hear = [refused](const Result<message::OpenInterfaceReply>& reply) {
    constexpr std::string_view kWhy = "keeps at most 8192 waiting requests";
    if (!reply && reply.error().message.find(kWhy) != std::string::npos) ++*refused;
  };

  auto held = HoldUp(*robot);
  for (int asked = 0; asked < kMany && *refused == 0; ++asked) greedy.AskToOpen(hear);
  EXPECT_TRUE(EventuallyTrue([&] { return *refused > 0; }));
  held.unlock();

  EXPECT_TRUE(modest.Subscribe(WantingNewest()).ok());
}

TEST_P(GreedyViewer, TooManyUnprocessedNoticesCloseTheChannel) {
  constexpr int kMany = 100'000;

  const auto held = HoldUp(*robot);
  // The worker waits while it executes this request.
  greedy.Ask(WantingNewest(), [](const auto& /*reply*/) {});
  for (int sent = 0; sent < kMany && greedy.is_open();) sent += greedy.CloseAny() ? 1 : 0;

  EXPECT_TRUE(EventuallyTrue([&] { return !greedy.is_open(); }));
  EXPECT_TRUE(modest.is_open());
}

TEST_P(GreedyViewer, ManyUnsubscribesDoNotCloseTheChannel) {
  constexpr int kMany = 20'000;
  const auto subscribed = modest.Subscribe(WantingNewest());
  ASSERT_TRUE(subscribed.ok());

  auto held = HoldUp(*robot);
  for (int i = 0; i < kMany && modest.is_open(); ++i) modest.Unsubscribe(subscribed->handle);
  held.unlock();

  EXPECT_TRUE(EventuallyTrue([&] { return modest.Subscribe(WantingNewest()).ok(); }))
      << "once the process has come to what was asked before";
}

TEST_P(GreedyViewer, RefusesAFewLongPendingRequests) {
  const std::string name(std::size_t{900} << 10U, 'x');
  const auto refused = std::make_shared<std::atomic<int>>(0);
  const auto hear = [refused](const Result<message::SubscribeReply>& reply) {
    constexpr std::string_view kWhy = "at most 8388608 bytes in total";
    if (!reply && reply.error().message.find(kWhy) != std::string::npos) ++*refused;
  };

  auto held = HoldUp(*robot);
  EXPECT_TRUE(EventuallyTrue([&] {
    greedy.Ask(Wanting({name}), hear);  // until the link is full
    return *refused > 0;
  }));
  held.unlock();

  EXPECT_TRUE(modest.Subscribe(WantingNewest()).ok());
}

INSTANTIATE_TEST_SUITE_P(Over, GreedyViewer, testing::ValuesIn(PlainNetworkKinds()), NameOfNetwork);

}  // namespace
