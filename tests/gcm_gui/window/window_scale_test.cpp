#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gtest/gtest.h>
#include <tendon/base/os/thread.h>

#include <QLineEdit>
#include <QTest>
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "support/announcing.h"
#include "support/large_system.h"
#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

constexpr int kProcesses = 20;
constexpr int kOfEach = 50;

/// Measures the CPU time of the handlers of a whole window for a thousand components. The times are
/// only reported, because they depend on the build.
class WindowScaleTest : public WindowFixture {
 protected:
  WindowScaleTest() : large_(LargeSystem(kProcesses, kOfEach)) {}

  template <typename Step>
  void Time(const char* what, Step step) {
    const auto before = os::ThreadCpuTime();
    step();
    Note(what, os::ThreadCpuTime() - before);
  }

  /// Processes events until `done` is true, and reports the longest turn of the event loop.
  template <typename Done>
  void TimeTurns(const char* what, Done done) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(kTestTimeout);
    std::chrono::nanoseconds longest{0};
    while (!done() && std::chrono::steady_clock::now() < end) {
      const auto before = os::ThreadCpuTime();
      QCoreApplication::processEvents();
      longest = std::max(longest, std::chrono::nanoseconds(os::ThreadCpuTime() - before));
    }
    EXPECT_TRUE(done());
    Note(what, longest);
  }

  void Note(const char* what, std::chrono::nanoseconds used) {
    const double milliseconds = std::chrono::duration<double, std::milli>(used).count();
    std::printf("  %-44s %7.2f ms\n", what, milliseconds);
    RecordProperty(what, std::to_string(milliseconds));
  }

  SystemBuilder large_;
};

TEST_F(WindowScaleTest, HandlesAThousandComponents) {
  Time("the first of them appear", [&] { store_.replace(large_.catalogue()); });
  TimeTurns("the longest turn until all are there",
            [&] { return !IsAnnouncing(store_) && !window_.graph().graph().isArranging(); });
  EXPECT_EQ(window_.graph().graph().components().size(), std::size_t{kProcesses * kOfEach});
  TimeTurns("the longest turn until it has settled",
            [turns = 0]() mutable { return ++turns > 50; });
  (void)large_.TakeChanges();  // the shown catalogue already contains these changes

  large_.Disconnect({LargeProcess(3), LargeComponent(7), "Arm"});
  Time("one is disconnected", [&] { store_.apply(large_.TakeChanges()); });
  large_.Process(LargeProcess(6), ProcessState::kLost, 1);
  Time("a process is lost", [&] { store_.apply(large_.TakeChanges()); });

  const auto path = ToQString(LargeProcess(3) + '/' + LargeComponent(7));
  Time("one is selected", [&] { window_.selection().select(path); });
  Time("a connection is begun", [&] { QTest::keyClick(&window_, Qt::Key_C); });
  EXPECT_TRUE(window_.connectMode().active());
  Time("it is left", [&] { QTest::keyClick(&window_, Qt::Key_Escape); });
  QTest::keyClick(&window_, Qt::Key_F, Qt::ControlModifier);
  Time("a filter is typed and applied", [&] {
    QTest::keyClicks(&window_.catalogue().filterField(), "component_107");
    QTest::keyClick(&window_.catalogue().filterField(), Qt::Key_Return);
  });
  link_.setUnreachable("127.0.0.1:10705 refused");
  TimeTurns("the longest turn after the GCM is lost",
            [turns = 0]() mutable { return ++turns > 20; });
}

}  // namespace
}  // namespace tendon::gui
