#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gtest/gtest.h>
#include <tendon/base/clock.h>

#include <QImage>
#include <QPixmap>
#include <QTest>
#include <cmath>

#include "support/picture_file.h"
#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

/// Draws the window in the state of the reference pictures, and saves the picture for people. Also
/// checks everything that can be checked automatically.
class WindowPicturesTest : public WindowFixture {
 protected:
  WindowPicturesTest() : WindowFixture(WallClock() - 12 * kSecond) {}
  ~WindowPicturesTest() override { Theme::instance().choose(Theme::Choice::kSystem); }

  void FillPlot() {
    source_.send("robot/arm/state.Joints", test::JointStateSchema(3),
                 {0.2013, -0.3987, 0.0004, 0, 0, 0});
    window_.catalogue().tree().reveal("robot/arm/state.Joints.position[2]");
    window_.selection().select("robot/arm/state.Joints.position");
    QTest::keyClick(&window_, Qt::Key_P);
    const std::int64_t now = SteadyClock().Now().time_since_epoch().count();
    for (int joint = 0; joint < 3; ++joint) {
      std::vector<Sample> samples;
      for (int i = 0; i < 30000; ++i) {
        if (i >= 17200 && i < 17800) continue;
        const double t = i * 1e-3;
        samples.push_back({now - 30 * kSecond + std::int64_t{i} * 1'000'000,
                           static_cast<std::uint64_t>(i),
                           std::sin(t * (0.7 - 0.1 * joint) + joint) * (1.1 - 0.3 * joint)});
      }
      Q_EMIT source_.samplesArrived(
          QStringLiteral("robot/arm/state.Joints.position[%1]").arg(joint), samples);
    }
  }

  void FillInspector() {
    source_.send("robot/arm/state.Cycle", CycleSchema(), {1e-3, 16e-6, 38e-6, 0});
    SendSummary(source_, "robot/arm", {1000, 1e-3, 16e-6, 31e-6, 57e-6, 38e-6});
  }

  void FillActivity() {
    Action action;
    action.required = {"desk", "view", "Host"};
    action.provided = {"desk", "host_monitor", "state"};
    activity_.finish(activity_.begin(action), 0.038, {});
    action.verb = Action::Verb::kDisconnect;
    action.provided = {};
    activity_.finish(activity_.begin(action), 0.004, {});
  }

  QImage Grab(const QString& name) {
    // Time for the timers that lay out and draw.
    QTest::qWait(400);
    const QImage image = window_.grab().toImage();
    EXPECT_TRUE(image.save(PictureFile(name)));
    return image;
  }
};

TEST_F(WindowPicturesTest, RendersConnectMode) {
  for (const auto& [choice, name] : {std::pair{Theme::Choice::kDark, "window-dark"},
                                     std::pair{Theme::Choice::kLight, "window-light"}}) {
    Theme::instance().choose(choice);
    if (activity_.rowCount() == 0) {
      FillActivity();
      FillPlot();
      FillInspector();
      window_.graph().fit();
      const auto robot =
          window_.graph().pointOf({Side::kRequired, {"desk", "teleoperation", "Robot"}});
      QTest::mouseClick(window_.graph().viewport(), Qt::LeftButton, {}, robot.value());
      window_.selection().select("robot/arm");
      FillInspector();
    }
    const QImage image = Grab(name);
    EXPECT_EQ(image.size(), QSize(1280, 800) * image.devicePixelRatio());
    EXPECT_EQ(image.pixelColor(640, 3), Theme::instance().color(Token::kPanel));
  }
}

TEST_F(WindowPicturesTest, RendersAnEmptySystem) {
  Theme::instance().choose(Theme::Choice::kDark);
  store_.replace(Catalogue::At(0));
  Grab("window-empty");
}

TEST_F(WindowPicturesTest, RendersANewConnection) {
  Theme::instance().choose(Theme::Choice::kLight);
  system_.Connect({"desk", "teleoperation", "Robot"}, {"robot", "controller", "Control"});
  system_.Connect({"desk", "view", "Host"}, {"desk", "host_monitor", "state"},
                  ConnectionState::kFailed, "no reply from desk in 2 s");
  Show();
  window_.selection().select("desk/teleoperation/Robot");
  Grab("window-connected");
}

}  // namespace
}  // namespace tendon::gui
