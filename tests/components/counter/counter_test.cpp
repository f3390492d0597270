#include <components/counter/counter.h>
#include <components/counter/counter_client.h>
#include <gtest/gtest.h>
#include <tendon/manager/local_manager.h>
#include <tests/support/wait.h>

namespace counter {
namespace {

/// Returns the newest value of a column of the default table.
template <typename T>
T Newest(const tendon::Component& component, const char* column) {
  T value{};
  const auto* found =
      dynamic_cast<const tendon::Column<T>*>(component.tables().front()->Find(column));
  EXPECT_NE(found, nullptr) << column;
  if (found != nullptr) (void)found->ReadNewest(value);
  return value;
}

/// A client that controls a counter from the test's thread.
class Hand : public tendon::Component {
 public:
  explicit Hand(std::string name) : Component(std::move(name)) {
    auto& counter = AddRequiredInterface("Counter");
    counter.AddFunction(set_step, "SetStep");
    counter.AddFunction(reset, "Reset");
  }

  tendon::WriteFunction<std::int32_t> set_step;
  tendon::VoidFunction reset;
};

class CounterTest : public testing::Test {
 protected:
  tendon::LocalManager manager_;
  Counter& counter_ = manager_.Add<Counter>("counter");

  [[nodiscard]] std::int64_t Value() const { return Newest<std::int64_t>(counter_, "Value"); }
};

TEST_F(CounterTest, CountsOnceACycle) {
  ASSERT_TRUE(manager_.StartAll());

  ASSERT_TRUE(EventuallyTrue([&] { return Value() >= 10; }));

  ASSERT_TRUE(manager_.StopAll());
  EXPECT_EQ(Value(), static_cast<std::int64_t>(counter_.tables().front()->next_tick()));
}

TEST_F(CounterTest, UsesTheStepSetByAClient) {
  auto& hand = manager_.Add<Hand>("hand");
  ASSERT_TRUE(manager_.Connect({"hand", "Counter"}, {"counter", "Control"}));
  ASSERT_TRUE(manager_.StartAll());

  EXPECT_EQ(hand.set_step(-1000), tendon::Status::kQueued);
  EXPECT_TRUE(EventuallyTrue([&] { return Value() < -100'000; }));

  EXPECT_EQ(hand.set_step(0), tendon::Status::kQueued);
  EXPECT_EQ(hand.reset(), tendon::Status::kQueued);
  EXPECT_TRUE(EventuallyTrue([&] { return Value() == 0; }));
}

TEST_F(CounterTest, ClientResetsTheCounterAtAThousand) {
  auto& client = manager_.Add<CounterClient>("client");
  ASSERT_TRUE(manager_.Connect({"client", "Counter"}, {"counter", "Control"}));
  ASSERT_TRUE(manager_.StartAll());

  EXPECT_TRUE(EventuallyTrue([&] { return Newest<std::uint64_t>(client, "Resets") >= 2; }));

  const auto cycles = static_cast<std::int64_t>(counter_.tables().front()->next_tick());
  EXPECT_LT(Value(), cycles - 500);
}

TEST_F(CounterTest, AnUnconnectedClientStaysActive) {
  auto& client = manager_.Add<CounterClient>("client");
  ASSERT_TRUE(manager_.StartAll());

  ASSERT_TRUE(EventuallyTrue([&] { return client.tables().front()->next_tick() > 3; }));

  EXPECT_EQ(client.state(), tendon::ComponentState::kActive);
  EXPECT_EQ(Newest<std::uint64_t>(client, "Resets"), 0U);
}

}  // namespace
}  // namespace counter
