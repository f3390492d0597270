#include <gcm_gui/activity/activity_strip.h>
#include <gcm_gui/help/tour.h>
#include <gcm_gui/help/tour_card.h>
#include <gcm_gui/inspector/inspector.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gcm_gui/views/tab_panel.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTest>

#include "support/picture_file.h"
#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

class TourTest : public WindowFixture {
 protected:
  TourTest() { window_.catalogue().tree().setFocus(); }
  ~TourTest() override { Theme::instance().choose(Theme::Choice::kSystem); }

  [[nodiscard]] Tour& tour() const { return window_.tour(); }
  [[nodiscard]] QPushButton& button(const char* name) const {
    return *window_.findChild<QPushButton*>(name);
  }
  [[nodiscard]] QString text(const char* name) const {
    return window_.findChild<QLabel*>(name)->text();
  }
  [[nodiscard]] QRect card() const {
    const auto* card = window_.findChild<QFrame*>("tour.card");
    return {card->mapTo(&window_, QPoint()), card->size()};
  }
  [[nodiscard]] QRect PlaceOf(const QWidget& widget) const {
    return {widget.mapTo(&window_, QPoint()), widget.size()};
  }
  /// Presses the key in the widget with the focus, as a user would.
  void Press(Qt::Key key) { QTest::keyClick(window_.focusWidget(), key); }

  void Choose(const QString& name) {
    auto* help = window_.findChild<QMenuBar*>("menus")->actions().back()->menu();
    help->findChild<QAction*>(name)->trigger();
  }

  /// Expects that the card is completely visible and no text is cut off.
  void ExpectWhole() const {
    EXPECT_TRUE(window_.rect().contains(card()));
    for (const char* name : {"tour.title", "tour.text", "tour.place"}) {
      const auto* label = window_.findChild<QLabel*>(name);
      EXPECT_GE(label->height(), label->heightForWidth(label->width())) << name;
    }
  }
};

TEST_F(TourTest, TheMenuStartsTheTourOfAllSteps) {
  EXPECT_FALSE(tour().isRunning());
  Choose("Tour of the window");
  ASSERT_TRUE(tour().isRunning());
  QSet<QString> titles;
  for (int step = 1; step <= 6; ++step) {
    EXPECT_EQ(text("tour.place"), QStringLiteral("%1 of 6").arg(step));
    EXPECT_FALSE(tour().hole().isEmpty());
    EXPECT_TRUE(window_.rect().contains(tour().hole()));
    titles.insert(text("tour.title"));
    ExpectWhole();
    QTest::mouseClick(&button("tour.next"), Qt::LeftButton);
  }

  EXPECT_EQ(titles.size(), 6);
  EXPECT_FALSE(tour().isRunning());
  EXPECT_TRUE(window_.catalogue().tree().hasFocus());
}

TEST_F(TourTest, HighlightsItsSubjectWithTheCardNextToIt) {
  tour().start();

  EXPECT_TRUE(tour().hole().contains(PlaceOf(window_.catalogue()).adjusted(2, 2, -2, -2)));
  EXPECT_FALSE(card().intersects(tour().hole()));

  Press(Qt::Key_Right);
  Press(Qt::Key_Right);
  EXPECT_TRUE(tour().hole().contains(PlaceOf(window_.inspector()).adjusted(2, 2, -2, -2)));
  EXPECT_FALSE(card().intersects(tour().hole()));
}

TEST_F(TourTest, ArrowKeysStepAndEscapeEndsTheTour) {
  tour().start();
  EXPECT_TRUE(button("tour.next").hasFocus());
  EXPECT_FALSE(button("tour.back").isEnabled());

  Press(Qt::Key_Return);
  Press(Qt::Key_Right);
  EXPECT_EQ(text("tour.place"), "3 of 6");
  Press(Qt::Key_Left);
  EXPECT_EQ(text("tour.place"), "2 of 6");
  Press(Qt::Key_Left);
  Press(Qt::Key_Left);
  EXPECT_EQ(text("tour.place"), "1 of 6");
  Press(Qt::Key_Escape);

  EXPECT_FALSE(tour().isRunning());
  EXPECT_TRUE(window_.catalogue().tree().hasFocus());
}

TEST_F(TourTest, TabStaysInTheCardAndEnterPressesAButton) {
  tour().start();
  Press(Qt::Key_Right);
  QStringList way;
  for (int i = 0; i < 3; ++i) {
    Press(Qt::Key_Tab);
    way.append(window_.focusWidget()->objectName());
  }
  EXPECT_EQ(way, (QStringList{"tour.skip", "tour.back", "tour.next"}));

  QTest::keyClick(window_.focusWidget(), Qt::Key_Backtab, Qt::ShiftModifier);
  Press(Qt::Key_Return);
  EXPECT_EQ(text("tour.place"), "1 of 6");
  EXPECT_TRUE(button("tour.next").hasFocus()) << "Back can no longer be pressed";

  Press(Qt::Key_Tab);
  Press(Qt::Key_Return);
  EXPECT_FALSE(tour().isRunning());
}

TEST_F(TourTest, BlocksKeysAndClicksBehindIt) {
  window_.selection().select("robot/controller/Arm");
  tour().start();

  Press(Qt::Key_D);
  Press(Qt::Key_C);
  QTest::mouseClick(&tour(), Qt::RightButton, {}, tour().hole().center());
  QTest::mouseClick(&tour(), Qt::LeftButton, {}, tour().hole().center());

  EXPECT_TRUE(actions_.asked.isEmpty());
  EXPECT_FALSE(window_.connectMode().active());
  EXPECT_EQ(window_.selection().current(), "robot/controller/Arm");
  EXPECT_TRUE(tour().isRunning());
}

TEST_F(TourTest, OpensAHiddenPanelForItsStep) {
  window_.panels().show(Panels::Perspective::kPlot);
  window_.centre().setCurrent(1);
  ASSERT_FALSE(window_.inspector().isVisible());
  tour().start();

  Press(Qt::Key_Right);
  EXPECT_EQ(window_.centre().current(), 0);
  Press(Qt::Key_Right);
  EXPECT_TRUE(window_.inspector().isVisible());
  EXPECT_TRUE(tour().hole().contains(PlaceOf(window_.inspector()).adjusted(2, 2, -2, -2)));
  EXPECT_EQ(text("tour.place"), "3 of 6");
}

TEST_F(TourTest, SkipsStepsThatCannotBeShown) {
  window_.selection().select("desk/teleoperation");
  QTest::keyClick(&window_, Qt::Key_C);  // the candidates replace the inspector
  ASSERT_FALSE(window_.inspector().isVisible());
  tour().start();

  Press(Qt::Key_Right);
  Press(Qt::Key_Right);
  EXPECT_EQ(text("tour.title"), "Plot it live");
  EXPECT_EQ(text("tour.place"), "3 of 5");
  Press(Qt::Key_Left);
  EXPECT_EQ(text("tour.place"), "2 of 5");
}

TEST_F(TourTest, FollowsTheWindowSize) {
  tour().start();
  Press(Qt::Key_Right);
  for (const QSize& size : {QSize(1024, 700), QSize(1600, 1000)}) {
    window_.resize(size);
    QCoreApplication::processEvents();

    EXPECT_EQ(tour().geometry(), window_.rect());
    EXPECT_TRUE(tour().hole().contains(PlaceOf(window_.centre()).adjusted(2, 2, -2, -2)));
    ExpectWhole();
  }
}

TEST_F(TourTest, AnotherCommandEndsTheTour) {
  tour().start();

  QTest::keyClick(window_.focusWidget(), Qt::Key_K, Qt::ControlModifier);

  EXPECT_FALSE(tour().isRunning());
  EXPECT_TRUE(window_.findChild<QLineEdit*>("palette.field")->hasFocus());
}

TEST_F(TourTest, HasAnAccessibleNameAndDescription) {
  tour().start();
  const auto* card = window_.findChild<QFrame*>("tour.card");

  EXPECT_EQ(card->accessibleName(), "Tour, 1 of 6: The running system");
  EXPECT_EQ(card->accessibleDescription(), text("tour.text"));
}

TEST_F(TourTest, RendersEachStep) {
  for (const auto& [choice, name] :
       {std::pair{Theme::Choice::kDark, "dark"}, std::pair{Theme::Choice::kLight, "light"}}) {
    Theme::instance().choose(choice);
    tour().start();
    for (int step = 1; tour().isRunning(); ++step) {
      QCoreApplication::processEvents();  // the layout is updated
      const QImage image = window_.grab().toImage();
      EXPECT_TRUE(image.save(PictureFile(QStringLiteral("tour-%1-%2").arg(step).arg(name))));
      // The hole is bright; the area beside it is dimmed.
      EXPECT_EQ(image.pixelColor(QPoint(3, 3) * image.devicePixelRatio()) ==
                    Theme::instance().color(Token::kPanel),
                tour().hole().contains(3, 3));
      Press(Qt::Key_Right);
    }
  }
}

TEST(CardBeside, UsesTheFirstSideWithRoom) {
  const QRect room(0, 0, 1000, 800);
  const QSize card(300, 150);

  EXPECT_EQ(CardBeside({100, 100, 200, 200}, card, room), QRect(312, 125, 300, 150));
  EXPECT_EQ(CardBeside({800, 100, 200, 200}, card, room), QRect(488, 125, 300, 150));
  EXPECT_EQ(CardBeside({0, 0, 1000, 400}, card, room), QRect(350, 412, 300, 150));
  EXPECT_EQ(CardBeside({0, 400, 1000, 400}, card, room), QRect(350, 238, 300, 150));
}

TEST(CardBeside, StaysInsideTheWindowWithoutRoom) {
  const QRect room(0, 0, 1000, 800);
  const QSize card(300, 150);

  EXPECT_EQ(CardBeside(room, card, room), QRect(350, 638, 300, 150));
  EXPECT_TRUE(room.contains(CardBeside({-50, -50, 10, 10}, card, room)));
  EXPECT_TRUE(room.contains(CardBeside({990, 790, 10, 10}, card, room)));
}

}  // namespace
}  // namespace tendon::gui
