#pragma once

#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/theme/header_row.h>

#include <chrono>
#include <cstddef>
#include <vector>

class QActionGroup;
class QTabBar;
class QToolButton;

namespace tendon::gui {

class MemoryMeter;
class RateBadge;

/// The header of the plots. It has a tab for each page and a button [+]. For the current plot, it
/// shows the rate and the time span, and has buttons for the motion and the history.
class PlotHeader : public HeaderRow {
  Q_OBJECT

 public:
  explicit PlotHeader(QWidget* parent = nullptr);

  [[nodiscard]] QTabBar& tabs() { return *tabs_; }
  void setFigures(const std::vector<SourceFigures>& figures);
  /// For the arguments see MemoryMeter::setFigures().
  void setMemory(std::size_t used, std::size_t budget, bool is_thinned);
  void setWindow(std::chrono::nanoseconds length);
  void setPaused(bool paused);
  void setCursors(bool shown);
  void setSweeping(bool sweeping);
  void setWay(bool has_former, bool has_later);

 Q_SIGNALS:
  void newPlotRequested();
  void splitRequested();
  void windowChosen(std::chrono::nanoseconds length);
  void pauseToggled(bool paused);
  void cursorsToggled(bool shown);
  void sweepToggled(bool sweeping);
  void backRequested();
  void forwardRequested();
  void csvRequested();

 protected:
  /// If the header is narrow, hides some buttons. Only buttons whose functions also have a key and
  /// a menu entry are hidden.
  void resizeEvent(QResizeEvent* event) override;

 private:
  void buildWindowMenu();

  QTabBar* tabs_;
  QToolButton* plus_;
  QToolButton* split_;
  MemoryMeter* memory_;
  RateBadge* badge_;
  QToolButton* window_;
  QActionGroup* lengths_ = nullptr;
  QToolButton* back_;
  QToolButton* forward_;
  QToolButton* cursors_;
  QToolButton* csv_;
  QToolButton* sweep_;
  QToolButton* pause_;
};

/// Formats a time span: "30 s", "5 min", "1 h".
[[nodiscard]] QString LengthText(std::chrono::nanoseconds length);

}  // namespace tendon::gui
