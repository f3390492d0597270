#pragma once

#include <gcm_gui/plot/series/curve_set.h>

#include <QToolButton>
#include <vector>

namespace tendon::gui {

/// "1000 Hz · 0 lost": the rate of rows and the number of lost ones; red if any is lost. A click
/// shows the figures of each source.
class RateBadge : public QToolButton {
  Q_OBJECT

 public:
  explicit RateBadge(QWidget* parent = nullptr);

  void setFigures(const std::vector<SourceFigures>& figures);
};

/// "1000 Hz", "19.8 Hz", "0.5 Hz": three digits, two below 10 Hz, all before the point.
[[nodiscard]] QString RateText(double hz);
/// "; lost 600 in its process, 3 on the network"; empty without losses.
[[nodiscard]] QString PlacesText(const RowLosses& losses);
/// All sources together: "20–1000 Hz · 600 lost · 3 repeated · 1 silent". Empty without sources.
[[nodiscard]] QString BadgeText(const std::vector<SourceFigures>& figures);

}  // namespace tendon::gui
