#pragma once

#include <gcm_gui/plot/series/curve_set.h>

#include <QToolButton>
#include <vector>

namespace tendon::gui {

/// "1000 Hz · 0 lost": how fast rows arrive, and the proof that none is missing; red when one is.
/// A click tells each source's share.
class RateBadge : public QToolButton {
  Q_OBJECT

 public:
  explicit RateBadge(QWidget* parent = nullptr);

  void setFigures(const std::vector<SourceFigures>& figures);
};

/// "1000 Hz", "19.8 Hz", "0.5 Hz": three digits, or more in front of the point.
[[nodiscard]] QString RateText(double hz);
/// "; lost 600 in its process, 3 on the network"; empty where nothing was lost.
[[nodiscard]] QString PlacesText(const RowLosses& losses);
/// Of all sources: "20–1000 Hz · 600 lost · 3 repeated · 1 silent". Empty without any.
[[nodiscard]] QString BadgeText(const std::vector<SourceFigures>& figures);

}  // namespace tendon::gui
