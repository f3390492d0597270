#include <benchmarks/measurement.h>
#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/benchmarks/canvas_application.h>
#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/link_state.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/window/main_window.h>
#include <support/announcing.h>
#include <support/fakes.h>
#include <support/large_system.h>

#include <QKeyEvent>
#include <QLineEdit>
#include <QScrollBar>
#include <memory>

namespace tendon::benchmark {
namespace {

constexpr int kMembers = 100;  // members of one component

/// A whole window for a large system that exists only as a catalogue.
class LargeWindow {
 public:
  explicit LargeWindow(int components) {
    constexpr int kProcesses = 20;
    gui::SystemBuilder system = gui::LargeSystem(kProcesses, components / kProcesses, kMembers);
    catalogue_ = system.catalogue();
    link_.setAddress("127.0.0.1:10705", true);
    link_.setConnected();
    window_ = std::make_unique<gui::MainWindow>(gui::WindowParts{store_, link_, activity_, actions_,
                                                                 source_, calls_, checks_, plans_,
                                                                 reports_, recordings_});
  }

  /// Waits until all views show the whole system and are painted.
  void Fill() {
    window_->show();
    store_.replace(catalogue_);
    while (IsAnnouncing(store_) || window_->graph().graph().isArranging()) {
      QCoreApplication::processEvents();
    }
    window_->grab();
  }

  void Type(char letter) {
    QLineEdit& field = window_->catalogue().filterField();
    field.insert(QChar(letter));
    // Applies the filter without its delay of 120 ms.
    QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
    QCoreApplication::sendEvent(&field, &enter);
    window_->catalogue().grab();
  }
  void ClearFilter() { window_->catalogue().filterField().clear(); }

  void Pan(int pixels) {
    QScrollBar& bar = *window_->graph().horizontalScrollBar();
    bar.setValue(bar.value() + pixels);
    window_->graph().viewport()->grab();
  }
  void ShowAll() { window_->graph().fit(); }
  void ZoomIn() { window_->graph().zoomIn(); }

 private:
  CanvasApplication application_;  // must exist before all widgets
  Catalogue catalogue_ = Catalogue::At(0);
  gui::CatalogueStore store_;
  gui::LinkState link_;
  gui::ActivityModel activity_;
  gui::RecordingActions actions_;
  gui::ScriptedSignals source_;
  gui::ScriptedCalls calls_;
  gui::ScriptedChecks checks_;
  gui::ScriptedPlans plans_;
  gui::ScriptedReports reports_;
  gui::ScriptedRecordings recordings_;
  std::unique_ptr<gui::MainWindow> window_;
};

/// One window that all cases except the first one share.
class WindowDesk {
 public:
  explicit WindowDesk(int components) : components_(components) {}

  LargeWindow& window() {
    if (!window_) {
      window_ = std::make_unique<LargeWindow>(components_);
      window_->Fill();
    }
    return *window_;
  }

 private:
  int components_;
  std::unique_ptr<LargeWindow> window_;
};

template <typename Action>
Pair Milliseconds(Action action) {
  constexpr double kMilli = 1e-6;
  return {.ours = NanosecondsEach(1, [&](std::uint64_t) { action(); }) * kMilli};
}

}  // namespace

std::vector<Case> WindowCases(const Effort& effort) {
  const int components = effort.is_tiny ? 20 : 1000;
  const auto desk = std::make_shared<WindowDesk>(components);
  return {{.id = "W1",
           .what = "window over 1000 components, 100 k members: start",
           .unit = "ms",
           .stretch = 1000,
           .repetition = [components]() -> std::optional<Pair> {
             return Milliseconds([components] { LargeWindow(components).Fill(); });
           },
           .runs_once = true},
          {.id = "W2",
           .what = "the same: a key in the filter, until painted",
           .unit = "ms",
           .stretch = 50,
           .repetition = [desk, turn = 0]() mutable -> std::optional<Pair> {
             constexpr std::string_view kTyped = "component_107";
             const auto place = static_cast<std::size_t>(turn++) % kTyped.size();
             if (place == 0) desk->window().ClearFilter();
             return Milliseconds([&] { desk->window().Type(kTyped[place]); });
           }},
          {.id = "W3",
           .what = "the same: a frame of a pan of the whole graph",
           .unit = "ms",
           .stretch = 20,
           .repetition = [desk, turn = 0]() mutable -> std::optional<Pair> {
             if (turn == 0) desk->window().ShowAll();
             if (turn == 0) desk->window().ZoomIn();  // so that the view can be moved
             const int pixels = ++turn % 2 == 0 ? 16 : -16;
             return Milliseconds([&] { desk->window().Pan(pixels); });
           }}};
}

}  // namespace tendon::benchmark
