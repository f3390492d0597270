#include <gcm_gui/inspector/inspector.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/image_view.h>
#include <gtest/gtest.h>

#include <QTabBar>
#include <QTest>

#include "support/picture_file.h"
#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

class PictureValuesTest : public WindowFixture {
 protected:
  ~PictureValuesTest() override { Theme::instance().choose(Theme::Choice::kSystem); }

  void OpenValues() {
    auto& tabs = *window_.inspector().findChild<QTabBar*>("inspectorTabs.tabs");
    QTest::mouseClick(&tabs, Qt::LeftButton, {}, tabs.tabRect(1).center());
  }
  /// Returns a picture that changes from black to red downwards, and to green to the right.
  static RawImage Colours(int width, int height) {
    RawImage picture{.width = static_cast<std::uint64_t>(width),
                     .height = static_cast<std::uint64_t>(height),
                     .encoding = "rgb8",
                     .data = {}};
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        picture.data.append(static_cast<char>(255 * y / height));
        picture.data.append(static_cast<char>(255 * x / width));
        picture.data.append('\x60');
      }
    }
    return picture;
  }
};

TEST_F(PictureValuesTest, ShowsAnImageBelowTheNumbersOfItsComponent) {
  window_.selection().select("robot/arm");
  OpenValues();
  source_.sendPicture("robot/arm/state.Joints", Colours(640, 480));

  const auto views = [this] { return window_.inspector().findChildren<ImageView*>("picture"); };
  const auto shown = [&]() -> ImageView* {
    for (ImageView* view : views()) {
      if (view->isVisible() && view->image().width() == 640) return view;
    }
    return nullptr;
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return shown() != nullptr; }, kTestTimeout));
  EXPECT_EQ(shown()->words(), "Joints · 640 × 480 rgb8");
  for (const auto& [choice, name] :
       {std::pair{Theme::Choice::kDark, "dark"}, std::pair{Theme::Choice::kLight, "light"}}) {
    Theme::instance().choose(choice);
    QCoreApplication::processEvents();
    EXPECT_TRUE(window_.grab().save(PictureFile(QStringLiteral("image-value-") + name)));
  }

  window_.selection().select("robot/controller");
  EXPECT_EQ(shown(), nullptr);
}

}  // namespace
}  // namespace tendon::gui
