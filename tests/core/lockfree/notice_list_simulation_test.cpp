#include <gtest/gtest.h>
#include <support/simulation/report_matchers.h>
#include <support/simulation/simulated_atomics.h>
#include <support/simulation/weakened_atomics.h>
#include <tendon/lockfree/notice_list.h>

#include <array>
#include <memory>
#include <utility>

namespace tendon::simulation {
namespace {

/// A notice that points to plain memory, which is overwritten when the notice is freed.
class Notice {
 public:
  explicit Notice(Plain<int>& memory) : memory_(&memory) { memory.Write(1); }
  Notice(Notice&& other) noexcept : memory_(std::exchange(other.memory_, nullptr)) {}
  Notice& operator=(Notice&&) = delete;
  Notice(const Notice&) = delete;
  Notice& operator=(const Notice&) = delete;
  ~Notice() {
    if (memory_ != nullptr) memory_->Write(0);
  }

  [[nodiscard]] int Read() const { return memory_->Read(); }

 private:
  Plain<int>* memory_;
};

template <typename Atomics>
struct Delivery {
  std::array<Plain<int>, 3> memory{Plain<int>(0), Plain<int>(0), Plain<int>(0)};
  NoticeList<Notice, Atomics> list;
  int taken = 0;

  void Send() {
    for (Plain<int>& one : memory) list.Send(Notice(one));
  }
  void Take() {
    list.Take([this](const Notice& notice) {
      Check(notice.Read() == 1, "it was not written, or freed already");
      ++taken;
    });
  }
};

template <typename Atomics>
Report ExploreDelivery() {
  return Explore([](Scenario& scenario) {
    const auto shared = std::make_shared<Delivery<Atomics>>();
    scenario.Thread([=] { shared->Send(); });
    scenario.Thread([=] {
      shared->Take();
      shared->Take();
    });
    scenario.Finally([=] {
      shared->Take();
      Check(shared->taken == 3, "each comes once");
    });
  });
}

TEST(NoticeListSimulation, DeliversEachOnceAndFreesNoneInUse) {
  EXPECT_THAT(ExploreDelivery<SimulatedAtomics>(), Passes());
}

TEST(NoticeListSimulation, NeedsItsReleases) {
  EXPECT_THAT(ExploreDelivery<WithoutRelease>(), FailsWith("races"));
}

TEST(NoticeListSimulation, NeedsItsAcquires) {
  EXPECT_THAT(ExploreDelivery<WithoutAcquire>(), FailsWith("races"));
}

}  // namespace
}  // namespace tendon::simulation
