#include "samples.h"

#include <gtest/gtest.h>

#include <QTest>

#include "gcm_gui/support/picture_file.h"

namespace tendon::gui {

std::vector<Sample> Rows(std::uint64_t from, std::uint64_t to,
                         const std::function<double(double seconds)>& value) {
  std::vector<Sample> rows;
  for (std::uint64_t tick = from; tick < to; ++tick) {
    const auto time = static_cast<std::int64_t>(tick) * kMillisecond;
    rows.push_back(
        {.time_ns = time, .tick = tick, .value = value(static_cast<double>(time) / 1e9)});
  }
  return rows;
}

void ShowView(PlotView& view) {
  view.resize(640, 320);
  view.show();
  [[maybe_unused]] const bool exposed = QTest::qWaitForWindowExposed(&view);
}

QImage Painted(PlotView& view) {
  view.refresh();
  return view.grab().toImage();
}

void KeepPicture(const QImage& image, const QString& name) {
  EXPECT_TRUE(image.save(PictureFile(name)));
}

}  // namespace tendon::gui
