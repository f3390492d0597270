#include <gcm_gui/session/catalogue_store.h>
#include <gtest/gtest.h>

#include <QTest>
#include <vector>

#include "support/announcing.h"
#include "support/large_system.h"

namespace tendon::gui {
namespace {

constexpr int kTestTimeout = 120'000;  // ms; bounds a test that fails

class CatalogueStoreTest : public ::testing::Test {
 protected:
  CatalogueStoreTest() {
    QObject::connect(
        &store_, &CatalogueStore::changed, &store_,
        [this](const Catalogue&, const ChangedParts& touched) { told_.push_back(touched); });
  }

  void Show(SystemBuilder& system) { store_.apply(system.TakeChanges()); }
  [[nodiscard]] bool Finish() {
    return QTest::qWaitFor([&] { return !IsAnnouncing(store_); }, kTestTimeout);
  }
  /// Returns how often a whole process was reported as changed.
  [[nodiscard]] int Times(const std::string& process) const {
    int times = 0;
    for (const ChangedParts& step : told_) times += static_cast<int>(step.count({process, {}}));
    return times;
  }

  CatalogueStore store_;
  std::vector<ChangedParts> told_;
};

TEST_F(CatalogueStoreTest, AnnouncesAFewChangesAtOnce) {
  SystemBuilder system = LookSystem(0);

  Show(system);

  EXPECT_FALSE(IsAnnouncing(store_));
  EXPECT_EQ(told_.size(), 1u);
}

TEST_F(CatalogueStoreTest, AnnouncesManyComponentsInStepsAndEachOnce) {
  SystemBuilder system = LargeSystem(10, 50);

  Show(system);
  EXPECT_EQ(told_.size(), 1u);
  EXPECT_EQ(told_.front().size(), 2u) << "a hundred components are two processes";
  ASSERT_TRUE(Finish());

  EXPECT_EQ(told_.size(), 5u);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(Times(LargeProcess(i)), 1) << i;
}

TEST_F(CatalogueStoreTest, AnnouncesChangesMadeMeanwhile) {
  SystemBuilder system = LargeSystem(10, 50);
  Show(system);

  system.Process(LargeProcess(0), ProcessState::kLost, 1);
  Show(system);
  ASSERT_TRUE(Finish());

  EXPECT_EQ(Times(LargeProcess(0)), 2);
  EXPECT_EQ(Times(LargeProcess(9)), 1);
}

TEST_F(CatalogueStoreTest, RecordsWhenAComponentEnteredItsState) {
  SystemBuilder system = LookSystem(0);
  Show(system);
  EXPECT_FALSE(store_.stateSince("robot", "arm")) << "it was so before the window came";

  ComponentDescription arm = *system.catalogue().FindComponent("robot", "arm");
  arm.state = ComponentState::kSuspended;
  system.Component("robot", arm);
  Show(system);
  const auto since = store_.stateSince("robot", "arm");
  ASSERT_TRUE(since);
  arm.warning = "another thing";
  system.Component("robot", arm);
  Show(system);

  EXPECT_EQ(store_.stateSince("robot", "arm"), since);
  EXPECT_FALSE(store_.stateSince("robot", "force_sensor"));
}

TEST_F(CatalogueStoreTest, ASnapshotGivesNoTimeForAChangedState) {
  SystemBuilder system = LookSystem(0);
  Show(system);
  ComponentDescription arm = *system.catalogue().FindComponent("robot", "arm");
  arm.state = ComponentState::kSuspended;
  system.Component("robot", arm);
  Show(system);
  ASSERT_TRUE(store_.stateSince("robot", "arm"));
  const auto since = store_.stateSince("robot", "arm");

  store_.replace(system.catalogue());
  EXPECT_EQ(store_.stateSince("robot", "arm"), since) << "it is what it was";
  arm.state = ComponentState::kActive;
  system.Component("robot", arm);
  store_.replace(system.catalogue());

  EXPECT_FALSE(store_.stateSince("robot", "arm"));
}

}  // namespace
}  // namespace tendon::gui
