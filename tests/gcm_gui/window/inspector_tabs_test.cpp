#include <gcm_gui/call/call_panel.h>
#include <gcm_gui/inspector/inspector.h>
#include <gcm_gui/views/row_view.h>
#include <gcm_gui/views/tab_panel.h>
#include <gtest/gtest.h>

#include <QTabBar>

#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

/// Tests which tab is shown after a selection.
class InspectorTabs : public WindowFixture {
 protected:
  void Bring(const QString& title) {
    QTabBar& bar = *window_.findChild<QTabBar*>("inspectorTabs.tabs");
    for (int i = 0; i < bar.count(); ++i) {
      if (bar.tabText(i) == title) bar.setCurrentIndex(i);
    }
    EXPECT_EQ(Front(), title);
  }
  [[nodiscard]] QString Front() const {
    const QTabBar& bar = *window_.findChild<QTabBar*>("inspectorTabs.tabs");
    return bar.tabText(bar.currentIndex());
  }
  void Select(const QString& path) { window_.selection().select(path); }
};

TEST_F(InspectorTabs, SelectingACommandShowsItsFormFromAnyTab) {
  Select("robot/arm");
  for (const char* tab : {"Values", "Events", "Thread", "Config"}) {
    Bring(tab);

    Select("robot/arm/Drives.Stop");

    EXPECT_EQ(Front(), "Interfaces") << tab;
    EXPECT_TRUE(window_.findChild<CallPanel*>()->isVisible());
    const auto* list = window_.findChild<RowView*>("inspector.interfaces");
    EXPECT_EQ(list->currentIndex().data().toString(), "Stop");
    Select("robot/arm");
  }
}

TEST_F(InspectorTabs, SelectingANumberShowsTheValues) {
  Select("robot/arm");
  for (const char* tab : {"Interfaces", "Thread"}) {
    Bring(tab);

    Select("robot/arm/state.Joints.position[0]");

    EXPECT_EQ(Front(), "Values") << tab;
    Select("robot/arm");
  }
}

TEST_F(InspectorTabs, SelectingAComponentKeepsTheTab) {
  Select("robot/arm");
  Bring("Thread");
  Select("robot/controller");
  EXPECT_EQ(Front(), "Thread");

  Bring("Values");
  Select("robot/arm/state.Joints");
  EXPECT_EQ(Front(), "Values");
}

TEST_F(InspectorTabs, CatalogueChangesKeepTheTab) {
  Select("robot/arm/Drives.Stop");
  Bring("Values");

  system_.Process("another");
  Show();

  EXPECT_EQ(Front(), "Values");
}

}  // namespace
}  // namespace tendon::gui
