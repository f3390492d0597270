#include <gtest/gtest.h>

#include <memory>
#include <new>
#include <vector>

#include "core/interface/waiting_fixture.h"

namespace tendon_test {
namespace {

/// A value whose copy throws while memory is short.
struct Fragile {
  static inline bool is_memory_short = false;

  std::int32_t number = 0;

  Fragile() = default;
  explicit Fragile(std::int32_t value) : number(value) {}
  Fragile(const Fragile&) = default;
  ~Fragile() = default;
  Fragile& operator=(const Fragile& other) {
    if (is_memory_short) throw std::bad_alloc();
    number = other.number;  // NOLINT(bugprone-unhandled-self-assignment)
    return *this;
  }
};

}  // namespace
}  // namespace tendon_test

template <>
inline constexpr auto tendon::kPayload<tendon_test::Fragile> =
    tendon::Describe("test.Fragile", tendon::Field{"number", &tendon_test::Fragile::number});

namespace tendon_test {
namespace {

using tendon::CallerThreads;
using tendon::Overflow;
using tendon::Status;

/// Memory is short while this object exists.
class ShortOfMemory {
 public:
  ShortOfMemory() { Fragile::is_memory_short = true; }
  ShortOfMemory(const ShortOfMemory&) = delete;
  ShortOfMemory& operator=(const ShortOfMemory&) = delete;
  ~ShortOfMemory() { Fragile::is_memory_short = false; }
};

struct Store {
  tendon::Inbox inbox;
  tendon::ProvidedInterface desk{"Desk", &inbox};
  tendon::WriteEvent<Fragile> arrived;
  std::vector<std::int32_t> taken;

  Store() {
    desk.AddCommandWrite(&Store::Take, this, "Take");
    desk.AddCommandWrite(&Store::Take, this, "Follow").SetOverflow(Overflow::kLatestOnly);
    desk.AddCommandVoidReturn(&Store::Give, this, "Give");
    desk.AddEvent(arrived, "Arrived");
    inbox.SetAccepting(true);
  }
  void Take(const Fragile& value) { taken.push_back(value.number); }
  void Give(Fragile& value) { value.number = 7; }
};

/// Calls with values that throw when they are copied, from one thread or from any thread.
class ThrowingCopy : public testing::TestWithParam<CallerThreads> {
 protected:
  ThrowingCopy() {
    required_.SetCallers(GetParam());
    required_.AddFunction(take_, "Take");
    required_.AddFunction(follow_, "Follow");
    required_.AddFunction(give_, "Give");
    required_.AddEventWaiter(arrived_, "Arrived");
    required_.SetMailboxCapacity(4);
    connection_ = ConnectionOf(required_, store_.desk);
  }

  Store store_;
  tendon::Inbox inbox_;
  tendon::RequiredInterface required_{"Store", &inbox_};
  tendon::WriteFunction<Fragile> take_;
  tendon::WriteFunction<Fragile> follow_;
  tendon::VoidReturnFunction<Fragile> give_;
  tendon::EventWaiter<Fragile> arrived_;
  std::unique_ptr<tendon::Connection> connection_;
};

TEST_P(ThrowingCopy, OfAnArgumentFailsOnlyThatCall) {
  const Fragile first(1);
  {
    const ShortOfMemory memory;
    for (int i = 0; i < 2; ++i) EXPECT_EQ(take_(first), Status::kFailed);
    EXPECT_EQ(take_.Wait(first, 60s), Status::kFailed);
  }
  EXPECT_EQ(take_(Fragile(2)), Status::kQueued);

  store_.inbox.ExecuteQueued();

  EXPECT_EQ(store_.taken, std::vector<std::int32_t>{2});
  EXPECT_EQ(connection_->waiting(), 0U);
}

TEST_P(ThrowingCopy, OfTheLatestValueFailsOnlyThatCall) {
  {
    const ShortOfMemory memory;
    EXPECT_EQ(follow_(Fragile(1)), Status::kFailed);
  }
  EXPECT_EQ(follow_(Fragile(2)), Status::kQueued);

  store_.inbox.ExecuteQueued();

  EXPECT_EQ(store_.taken, std::vector<std::int32_t>{2});
}

/// There are as many records for answers as mailbox slots.
TEST_P(ThrowingCopy, OfAReplyFailsOnlyThatCall) {
  const Executor server(store_.inbox);
  Fragile result;
  for (int i = 0; i < 10; ++i) {
    const ShortOfMemory memory;
    EXPECT_EQ(give_.Wait(result, 60s), Status::kFailed);
  }

  EXPECT_EQ(give_.Wait(result, 60s), Status::kDone);

  EXPECT_EQ(result.number, 7);
}

TEST_P(ThrowingCopy, OfAnEventLosesOnlyThatEvent) {
  {
    const ShortOfMemory memory;
    store_.arrived(Fragile(1));
  }
  EXPECT_EQ(store_.arrived.lost(), 1U);
  store_.arrived(Fragile(2));

  Fragile value;
  EXPECT_EQ(arrived_.Wait(value, 0ms), Status::kDone);
  EXPECT_EQ(value.number, 2);
  EXPECT_EQ(store_.arrived.lost(), 1U);
}

TEST_P(ThrowingCopy, OfAnAwaitedEventFailsOnlyThatWait) {
  Fragile value;
  store_.arrived(Fragile(1));
  {
    const ShortOfMemory memory;
    EXPECT_EQ(arrived_.Wait(value, 0ms), Status::kFailed);
  }
  store_.arrived(Fragile(2));

  EXPECT_EQ(arrived_.Wait(value, 0ms), Status::kDone);
  EXPECT_EQ(value.number, 2);
}

INSTANTIATE_TEST_SUITE_P(, ThrowingCopy,
                         testing::Values(CallerThreads::kOneThread, CallerThreads::kManyThreads),
                         [](const auto& callers) {
                           return callers.param == CallerThreads::kOneThread ? "OneCaller"
                                                                             : "ManyCallers";
                         });

}  // namespace
}  // namespace tendon_test
