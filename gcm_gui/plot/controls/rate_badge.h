#pragma once

#include <gcm_gui/plot/series/curve_set.h>

#include <QToolButton>
#include <vector>

namespace tendon::gui {

/// Shows the rate of rows and the number of lost rows: "1000 Hz · 0 lost". The text is red if any
/// row is lost. If there is little room, only the end of the text is shown. A click shows the
/// figures of each source.
class RateBadge : public QToolButton {
  Q_OBJECT

 public:
  explicit RateBadge(QWidget* parent = nullptr);

  void setFigures(const std::vector<SourceFigures>& figures);
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

/// Formats a rate: "1000 Hz", "19.8 Hz", "0.5 Hz". The text has three digits, or two below 10 Hz.
/// All digits before the decimal point are shown.
[[nodiscard]] QString RateText(double hz);
/// Returns where rows were lost: "; lost 600 in its process, 3 on the network". Empty if no row was
/// lost.
[[nodiscard]] QString PlacesText(const RowLosses& losses);
/// Returns the figures of all sources together: "20–1000 Hz · 600 lost · 3 repeated · 1 silent".
/// Empty if there is no source.
[[nodiscard]] QString BadgeText(const std::vector<SourceFigures>& figures);

}  // namespace tendon::gui
