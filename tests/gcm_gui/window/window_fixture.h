#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/link_state.h>
#include <gcm_gui/window/main_window.h>
#include <gcm_gui/window/window_parts.h>
#include <gtest/gtest.h>

#include "support/fakes.h"
#include "support/sample_system.h"

namespace tendon::gui {

inline constexpr int kTestTimeout = 120'000;  // ms; bounds a test that fails

/// A whole window with a system that exists only as a catalogue.
class WindowFixture : public ::testing::Test {
 protected:
  explicit WindowFixture(std::int64_t lost_since = 0);

  [[nodiscard]] WindowParts Parts();
  /// Waits until every item of the graph has its position.
  void Show();

  SystemBuilder system_;
  CatalogueStore store_;
  LinkState link_;
  ActivityModel activity_;
  RecordingActions actions_;
  ScriptedSignals source_;
  ScriptedCalls calls_;
  ScriptedChecks checks_;
  ScriptedPlans plans_;
  ScriptedReports reports_;
  ScriptedRecordings recordings_;
  MainWindow window_{Parts()};
};

}  // namespace tendon::gui
