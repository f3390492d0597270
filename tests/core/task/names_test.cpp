#include <gtest/gtest.h>
#include <tendon/task/periodic_task.h>

#include <chrono>
#include <string>
#include <utility>

/// Common names that an author may use inside a component. The file must compile.
namespace author {

struct Order {
  int pieces = 0;
};
struct NumberedOrder {};
struct Followers {};
struct Posts {};

int Begin() { return 1; }
int Finish() { return 1; }
int Rest() { return 1; }
int GoOn() { return 1; }
int Obey() { return 1; }
int Follow() { return 1; }
int Unfollow() { return 1; }
int BecomeActive() { return 1; }
int Check(int value) { return value; }
int CheckNew() { return 1; }
int root() { return 1; }

class Counter final : public tendon::PeriodicTask {
 public:
  explicit Counter(std::string name) : PeriodicTask(std::move(name), std::chrono::seconds(1)) {}
  ~Counter() override { Join(); }

  int Use() {
    const Order order{.pieces = 3};
    (void)NumberedOrder{};
    (void)Followers{};
    (void)Posts{};
    return order.pieces + Begin() + Finish() + Rest() + GoOn() + Obey() + Follow() + Unfollow() +
           BecomeActive() + Check(1) + CheckNew() + root();
  }

 private:
  void Run() override {}
};

class Shelf final : public tendon::Component {
 public:
  explicit Shelf(std::string name) : Component(std::move(name)) {}
  int Use() { return Check(1) + CheckNew() + Begin(); }
};

TEST(Component, HidesNoNamesOfItsAuthor) {
  EXPECT_EQ(Counter("counter").Use(), 14);
  EXPECT_EQ(Shelf("shelf").Use(), 3);
}

}  // namespace author
