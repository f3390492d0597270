#include <gcm_gui/theme/header_row.h>
#include <gcm_gui/theme/metrics.h>
#include <gmock/gmock.h>

#include <QLabel>

namespace tendon::gui {
namespace {

TEST(HeaderRow, PlacesTheTitleLeftAndActionsRight) {
  HeaderRow head("Catalogue");
  auto* filter = new QLabel("filter");
  auto* count = new QLabel("106 items");
  head.addLeft(filter);
  head.addRight(count);
  head.resize(300, head.height());
  head.show();

  EXPECT_EQ(head.height(), kHeadHeight);
  EXPECT_EQ(head.accessibleName(), "Catalogue");
  const auto* title = head.findChild<QLabel*>();
  EXPECT_EQ(title->text(), "Catalogue");
  EXPECT_EQ(title->x(), kInset);
  EXPECT_GT(filter->x(), title->x());
  EXPECT_EQ(count->geometry().right(), 300 - kInset - 1);
}

}  // namespace
}  // namespace tendon::gui
