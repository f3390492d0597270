#include <gcm_gui/call/call_panel.h>
#include <gcm_gui/views/image_list.h>
#include <gcm_gui/views/image_view.h>
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "support/fakes.h"
#include "support/sample_system.h"

namespace tendon::gui {
namespace {

constexpr int kDrawTimeout = 120'000;  // ms; bounds a test that fails

RawImage Plain(int side, char shade) {
  return {.width = static_cast<std::uint64_t>(side),
          .height = static_cast<std::uint64_t>(side),
          .encoding = "mono8",
          .data = QByteArray(qsizetype{side} * side, shade)};
}

bool Shows(const ImageView& view, int side, int shade) {
  return QTest::qWaitFor(
      [&] {
        return view.image().width() == side && view.image().pixelColor(0, 0).value() == shade;
      },
      kDrawTimeout);
}

TEST(ImageView, ShowsAPictureAndItsFormat) {
  ImageView view("Video");
  view.resize(320, 400);

  view.show(Plain(8, 100));

  ASSERT_TRUE(Shows(view, 8, 100));
  EXPECT_EQ(view.words(), "Video · 8 × 8 mono8");
  EXPECT_EQ(view.accessibleName(), "Picture, Video · 8 × 8 mono8");
  EXPECT_FALSE(view.isHidden());
}

TEST(ImageView, ScalesALargePictureDown) {
  ImageView view("");

  view.show(Plain(4000, 100));

  ASSERT_TRUE(Shows(view, 1920, 100));
  EXPECT_EQ(view.words(), "4000 × 4000 mono8");
}

TEST(ImageView, ShowsTheLastOfManyPictures) {
  ImageView view("");

  for (int shade = 1; shade <= 100; ++shade) view.show(Plain(64, static_cast<char>(shade)));

  EXPECT_TRUE(Shows(view, 64, 100));
}

TEST(ImageView, ReportsAWrongSize) {
  ImageView view("");
  RawImage wrong = Plain(8, 1);
  wrong.data.chop(1);

  view.show(wrong);

  EXPECT_TRUE(QTest::qWaitFor([&] { return view.words().contains("do not match"); }, kDrawTimeout));
  EXPECT_TRUE(view.image().isNull());
  EXPECT_FALSE(view.isHidden());
}

TEST(ImageView, ClearingDiscardsPendingPictures) {
  ImageView view("");
  view.show(Plain(8, 100));
  view.clear();
  EXPECT_TRUE(view.isHidden());

  view.show(Plain(4, 50));

  EXPECT_TRUE(Shows(view, 4, 50));
}

TEST(ImageList, HasAViewForEachColumn) {
  ImageList shelf;
  ScriptedSignals source;
  QObject::connect(&source, &SignalSource::valuesArrived, &shelf, &ImageList::showValues);
  shelf.setColumns({"vision/camera/state.Left", "vision/camera/state.Right"});
  source.sendPicture("vision/camera/state.Left", Plain(8, 1));
  source.sendPicture("vision/camera/state.Right", Plain(8, 2));
  source.sendPicture("vision/other/state.Left", Plain(8, 3));

  EXPECT_EQ(shelf.findChildren<ImageView*>().size(), 2);
  EXPECT_FALSE(shelf.isHidden());

  shelf.setColumns({});
  EXPECT_TRUE(shelf.findChildren<ImageView*>().isEmpty());
  EXPECT_TRUE(shelf.isHidden());
}

TEST(CallPanel, ShowsAnImageReplyAsAPicture) {
  ScriptedCalls calls;
  CallPanel panel(calls);
  panel.show();
  panel.showCommand("vision/camera/Video.Take", Void("Take"));
  auto& view = *panel.findChild<ImageView*>();
  const auto& result = *panel.findChild<QLabel*>("call.result");
  const auto call = [&](const std::string& json) {
    QTest::mouseClick(panel.findChild<QPushButton*>("call.call"), Qt::LeftButton);
    calls.answer(Result<std::string>(json), 0.01);
  };

  call(R"({"width":2,"height":1,"encoding":"mono8","data":[9,9]})");
  ASSERT_TRUE(Shows(view, 2, 9));
  EXPECT_TRUE(result.isHidden());

  call(R"({"width":2,"height":2,"encoding":"mono8","data":[9,9]})");
  EXPECT_TRUE(QTest::qWaitFor([&] { return view.words().contains("do not match"); }, kDrawTimeout));
  EXPECT_FALSE(result.isHidden());

  call(R"({"width":2})");
  EXPECT_TRUE(view.isHidden());
  EXPECT_EQ(result.text(), "width: 2");
}

}  // namespace
}  // namespace tendon::gui
