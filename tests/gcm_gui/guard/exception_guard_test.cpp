#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/guard/view_cover.h>
#include <gtest/gtest.h>

#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <new>
#include <stdexcept>
#include <thread>

#include "guard/bomb.h"

/// Turns the leak sanitizer off. The exceptions of these tests pass through Qt, and Qt then does
/// not free its memory.
extern "C" int __lsan_is_turned_off() { return 1; }  // NOLINT(bugprone-reserved-identifier)

namespace tendon::gui {
namespace {

constexpr int kMaxWait = 120'000;  // ms; bounds a test that fails

/// Two views side by side in a window.
class ExceptionGuardTest : public ::testing::Test {
 protected:
  ExceptionGuardTest() {
    auto* column = new QVBoxLayout(&window_);
    for (auto** view : {&left_, &right_}) {
      *view = new QWidget;
      column->addWidget(*view);
    }
    ExceptionGuard::setName(*left_, "Left");
    ExceptionGuard::setName(*right_, "Right");
    window_.resize(400, 300);
    window_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window_, kMaxWait));
  }
  ~ExceptionGuardTest() override {
    for (QWidget* view : {left_, right_}) ExceptionGuard::instance().showAgain(*view);
  }

  /// Returns the faults of this view.
  static QList<ViewFault> FaultsOf(const QString& view) {
    QList<ViewFault> all = ExceptionGuard::instance().faults();
    all.removeIf([&](const ViewFault& fault) { return fault.view != view; });
    return all;
  }
  static bool WaitForFault(const QString& view) {
    return QTest::qWaitFor([&] { return !FaultsOf(view).isEmpty(); }, kMaxWait);
  }

  QWidget window_;
  QWidget* left_ = nullptr;
  QWidget* right_ = nullptr;
};

TEST_F(ExceptionGuardTest, ReportsAThrowingHandlerWithItsViewAndText) {
  Bomb bomb(*left_, QEvent::MouseButtonPress, [] { throw std::length_error("too long"); });

  QTest::mouseClick(left_, Qt::LeftButton);

  ASSERT_EQ(FaultsOf("Left").size(), 1);
  EXPECT_EQ(FaultsOf("Left")[0].what, "too long");
  EXPECT_EQ(FaultsOf("Left")[0].count, 1U);
  EXPECT_FALSE(FaultsOf("Left")[0].is_covered);
}

TEST_F(ExceptionGuardTest, ContainsNonStandardExceptions) {
  Bomb bomb(*left_, QEvent::MouseButtonPress, [] { throw 42; });

  QTest::mouseClick(left_, Qt::LeftButton);

  ASSERT_EQ(FaultsOf("Left").size(), 1);
  EXPECT_EQ(FaultsOf("Left")[0].what, "an exception without a message");
}

TEST_F(ExceptionGuardTest, ContainsTimersQueuedCallsAndBadAlloc) {
  QTimer timer;
  ExceptionGuard::setName(timer, "Timer");
  QObject::connect(&timer, &QTimer::timeout, [] { throw std::runtime_error("late"); });
  timer.start(0);
  QMetaObject::invokeMethod(
      left_, [] { throw std::bad_alloc(); }, Qt::QueuedConnection);

  EXPECT_TRUE(WaitForFault("Timer"));
  EXPECT_TRUE(WaitForFault("Left"));

  EXPECT_EQ(FaultsOf("Left")[0].what, "there is not enough memory");
}

TEST_F(ExceptionGuardTest, CountsRepeatedFaultsAsOne) {
  constexpr int kTimes = 1000;
  QSignalSpy changed(&ExceptionGuard::instance(), &ExceptionGuard::changed);
  QSignalSpy told(&ExceptionGuard::instance(), &ExceptionGuard::faultReported);
  for (int i = 0; i < kTimes; ++i) {
    ExceptionGuard::run(right_, ViewWork::kHandling, [] { throw std::runtime_error("again"); });
  }
  EXPECT_TRUE(changed.wait(kMaxWait));

  ASSERT_EQ(FaultsOf("Right").size(), 1);
  EXPECT_EQ(FaultsOf("Right")[0].count, std::uint64_t{kTimes});
  EXPECT_EQ(changed.count(), 1);
  const auto is_of_right = [](const QList<QVariant>& arguments) {
    return arguments[0].value<ViewFault>().view == "Right";
  };
  EXPECT_EQ(std::count_if(told.begin(), told.end(), is_of_right), 1);
}

TEST_F(ExceptionGuardTest, CoversAViewThatThrowsUntilTheUserRetries) {
  Bomb bomb(*left_, QEvent::Paint, [] { throw std::runtime_error("no picture"); });
  left_->update();

  ASSERT_TRUE(QTest::qWaitFor([&] { return left_->findChild<ViewCover*>() != nullptr; }, kMaxWait));
  const auto* cover = left_->findChild<ViewCover*>();
  EXPECT_EQ(cover->geometry(), left_->rect());
  EXPECT_TRUE(FaultsOf("Left")[0].is_covered);
  left_->repaint();
  left_->repaint();
  EXPECT_EQ(bomb.explosions(), 1);

  bomb.defuse();
  QTest::mouseClick(cover->findChild<QPushButton*>(), Qt::LeftButton);
  const int before = bomb.events();
  left_->repaint();

  EXPECT_GT(bomb.events(), before);
  EXPECT_TRUE(FaultsOf("Left").isEmpty());
  EXPECT_TRUE(QTest::qWaitFor([&] { return left_->findChild<ViewCover*>() == nullptr; }, kMaxWait));
}

TEST_F(ExceptionGuardTest, AnAbandonedPainterDoesNotBlockOtherViews) {
  Bomb bomb(*left_, QEvent::Paint, [&] {
    // Imitates the painter of a Qt function that an exception has left. The painter is never
    // destroyed, because it must not be ended.
    [[maybe_unused]] static auto* const left = new QPainter(left_);
    throw std::runtime_error("in the middle");
  });
  left_->repaint();
  ASSERT_TRUE(WaitForFault("Left"));

  bool is_drawn = false;
  Bomb watch(*right_, QEvent::Paint, [&] {
    QPainter painter;
    is_drawn = painter.begin(right_);
  });
  right_->repaint();

  EXPECT_TRUE(is_drawn);
}

TEST_F(ExceptionGuardTest, ReportsAThrowingThread) {
  std::thread thread([] {
    EXPECT_FALSE(
        ExceptionGuard::run("the thread of a test", [] { throw std::runtime_error("alone"); }));
  });
  thread.join();

  EXPECT_TRUE(WaitForFault("the thread of a test"));
}

TEST_F(ExceptionGuardTest, AThrowingReceiverDoesNotStopASignal) {
  struct Thrower : QObject {
    void hear() { throw std::runtime_error("deaf"); }
  } thrower;
  ExceptionGuard::setName(thrower, "Thrower");
  QTimer sender;
  int heard = 0;
  QObject::connect(&sender, &QTimer::timeout, &thrower, Guarded(&thrower, &Thrower::hear));
  QObject::connect(&sender, &QTimer::timeout, &window_, [&] { ++heard; });
  sender.start(0);

  EXPECT_TRUE(QTest::qWaitFor([&] { return heard > 2; }, kMaxWait));
  ASSERT_EQ(FaultsOf("Thrower").size(), 1);
  EXPECT_GE(FaultsOf("Thrower")[0].count, 3U);
}

}  // namespace
}  // namespace tendon::gui
