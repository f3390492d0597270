#pragma once

#include <gcm_gui/graph/graph_view.h>
#include <gtest/gtest.h>

#include <QTest>
#include <chrono>
#include <utility>

#include "support/announcing.h"
#include "support/fakes.h"
#include "support/sample_system.h"

namespace tendon::gui {

inline constexpr int kGraphTimeout = 120'000;  // ms; bounds a test that fails

/// The graph of a system that exists only as a catalogue; it is empty until Show().
class GraphFixture : public ::testing::Test {
 protected:
  explicit GraphFixture(SystemBuilder system,
                        std::chrono::milliseconds pointer_timeout = GraphView::kPointerTimeout)
      : system_(std::move(system)), view_(scene_, selection_, mode_, pointer_timeout) {}

  /// Shows the graph, and waits until all items have their positions.
  void Show() {
    store_.apply(system_.TakeChanges());
    EXPECT_TRUE(QTest::qWaitFor([this] { return !IsAnnouncing(store_) && !scene_.isArranging(); },
                                kGraphTimeout));
  }

  SystemBuilder system_;
  CatalogueStore store_;
  RecordingActions actions_;
  Selection selection_;
  ConnectMode mode_{store_, actions_};
  GraphScene scene_{store_, selection_, mode_};
  GraphView view_;
};

}  // namespace tendon::gui
