#include <gcm_gui/theme/state_mark.h>
#include <gcm_gui/theme/theme.h>
#include <gmock/gmock.h>

#include <QImage>
#include <QPainter>
#include <set>

namespace tendon::gui {
namespace {

// Returns the pixels that the shape covers, whatever the colour.
std::string ShapeOf(StateMark mark) {
  QImage image(24, 24, QImage::Format_ARGB32);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  PaintMark(painter, image.rect(), mark);
  painter.end();
  std::string shape;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) shape += qAlpha(image.pixel(x, y)) > 127 ? '#' : '.';
  }
  return shape;
}

TEST(StateMark, EveryMarkHasAWordAndAShape) {
  std::set<QString> words;
  for (int i = 0; i < kStateMarkCount; ++i) {
    const auto mark = static_cast<StateMark>(i);
    words.insert(WordOf(mark));
    EXPECT_NE(ShapeOf(mark).find('#'), std::string::npos) << qPrintable(WordOf(mark));
  }
  EXPECT_EQ(words.size(), kStateMarkCount);
}

TEST(StateMark, ComponentStatesDifferInShape) {
  std::set<std::string> shapes;
  for (const StateMark mark :
       {StateMark::kConstructed, StateMark::kReady, StateMark::kActive, StateMark::kSuspended,
        StateMark::kFinished, StateMark::kFaulted, StateMark::kWarning}) {
    shapes.insert(ShapeOf(mark));
  }
  EXPECT_EQ(shapes.size(), 7U);
}

TEST(StateMark, ConnectionStatesDifferInShape) {
  const std::set<std::string> shapes{ShapeOf(StateMark::kConnected), ShapeOf(StateMark::kPending),
                                     ShapeOf(StateMark::kNotConnected),
                                     ShapeOf(StateMark::kRefused)};
  EXPECT_EQ(shapes.size(), 4U);
}

}  // namespace
}  // namespace tendon::gui
