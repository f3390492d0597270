#pragma once

#include <gcm_gui/session/link_state.h>

#include <QFrame>
#include <cstdint>

class QLabel;

namespace tendon::gui {

class StateLabel;

/// A line across the window while its GCM is unreachable. It shows the age of the shown state and
/// the functions that still work.
class LostBanner : public QFrame {
  Q_OBJECT

 public:
  explicit LostBanner(const LinkState& link, QWidget* parent = nullptr);

  [[nodiscard]] QString text() const;

 public Q_SLOTS:
  /// Sets the present time, in ns since 1970.
  void setNow(qint64 now);

 private:
  void refresh();

  const LinkState& link_;
  std::int64_t now_ = 0;
  StateLabel* since_;
  QLabel* meaning_;
};

}  // namespace tendon::gui
