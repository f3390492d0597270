#pragma once

#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/plot/series/sample_ring.h>

#include <QImage>
#include <cstdint>
#include <functional>
#include <vector>

namespace tendon::gui {

inline constexpr std::int64_t kMillisecond = 1'000'000;
inline constexpr std::int64_t kSecond = 1000 * kMillisecond;

/// Rows [from, to) of a 1 kHz task: tick i is written at i ms.
std::vector<Sample> Rows(
    std::uint64_t from, std::uint64_t to,
    const std::function<double(double seconds)>& value = [](double seconds) { return seconds; });

/// Shows and lays out a view of 640 x 320 pixels, in front of all other windows.
void ShowView(PlotView& view);

/// Refreshes and paints the view as its timer would.
QImage Painted(PlotView& view);

/// Saves a picture for people; see PictureFile().
void KeepPicture(const QImage& image, const QString& name);

}  // namespace tendon::gui
