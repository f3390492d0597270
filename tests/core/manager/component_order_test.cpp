#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/manager/component_order.h>
#include <tendon/task/periodic_task.h>

#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using tendon::Component;
using tendon::ComponentOrder;
using testing::ElementsAre;
using namespace std::chrono_literals;

class Idle final : public tendon::PeriodicTask {
 public:
  explicit Idle(std::string name) : PeriodicTask(std::move(name), 1ms) {}

 private:
  void Run() override {}
};

class ComponentOrderTest : public testing::Test {
 protected:
  Idle& Add(const std::string& name) {
    auto task = std::make_shared<Idle>(name);
    components_.push_back(task);
    return *task;
  }
  [[nodiscard]] ComponentOrder Order() const { return ComponentOrder(components_); }
  static std::vector<std::string> Starts(const ComponentOrder& order) {
    std::vector<std::string> names;
    for (const auto& one : order.StartOrder()) names.push_back(one->name());
    return names;
  }
  static std::vector<std::string> Ends(const ComponentOrder& order) {
    std::vector<std::string> names;
    for (const auto& one : order.EndOrder(all_)) names.push_back(one.component->name());
    return names;
  }

  static inline const auto all_ = [](const Component& /*one*/) { return true; };
  ComponentOrder::Components components_;
};

TEST_F(ComponentOrderTest, ComponentsStartAsTheyWereAdded) {
  Add("b");
  Add("a");

  EXPECT_THAT(Starts(Order()), ElementsAre("b", "a"));
}

TEST_F(ComponentOrderTest, ALeaderStartsBeforeItsFollowersAndEndsAfterThem) {
  Idle& last = Add("last");
  Idle& middle = Add("middle");
  Idle& first = Add("first");
  ASSERT_TRUE(last.RunAfter(middle));
  ASSERT_TRUE(middle.RunAfter(first));

  EXPECT_THAT(Starts(Order()), ElementsAre("first", "middle", "last"));
  EXPECT_THAT(Ends(Order()), ElementsAre("last", "middle", "first"));
}

TEST_F(ComponentOrderTest, ALeaderOfAnotherManagerDoesNotCountAtTheEnd) {
  Idle foreign("foreign");
  Idle& follower = Add("follower");
  Add("other");
  ASSERT_TRUE(follower.RunAfter(foreign));

  EXPECT_THAT(Starts(Order()), ElementsAre("other", "follower"));
  EXPECT_EQ(Ends(Order()).size(), 2U);
}

TEST_F(ComponentOrderTest, AClientEndsBeforeItsServer) {
  Add("client");
  Add("server");
  ComponentOrder order = Order();

  order.AddConnection("client", "server");

  EXPECT_THAT(Ends(order), ElementsAre("client", "server"));
  const auto members = order.EndOrder(all_);
  EXPECT_THAT(members[0].before, ElementsAre());
  EXPECT_THAT(members[1].before, ElementsAre(0U));
}

TEST_F(ComponentOrderTest, AServerThatRunsAfterItsClientEndsFirst) {
  Idle& client = Add("client");
  Idle& server = Add("server");
  ASSERT_TRUE(server.RunAfter(client));
  ComponentOrder order = Order();

  order.AddConnection("client", "server");

  EXPECT_THAT(Ends(order), ElementsAre("server", "client"));
}

TEST_F(ComponentOrderTest, AComponentThatIsNotMeantIsLeftOutOfTheIndices) {
  Add("client");
  Add("between");
  Add("server");
  ComponentOrder order = Order();
  order.AddConnection("client", "between");
  order.AddConnection("client", "server");
  order.AddConnection("between", "server");

  const auto members = order.EndOrder([](const Component& one) { return one.name() != "between"; });

  ASSERT_EQ(members.size(), 2U);
  EXPECT_EQ(members[0].component->name(), "client");
  EXPECT_EQ(members[1].component->name(), "server");
  EXPECT_THAT(members[1].before, ElementsAre(0U));
}

TEST_F(ComponentOrderTest, ACycleOfConnectionsStillHasAnOrder) {
  Add("a");
  Add("b");
  ComponentOrder order = Order();

  order.AddConnection("a", "b");
  order.AddConnection("b", "a");

  EXPECT_EQ(Ends(order).size(), 2U);
}

}  // namespace
