#pragma once

#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/link_state.h>

#include <QFrame>

class QPushButton;

namespace tendon::gui {

class Pill;

/// The top of the window: the state of the GCM and the size of the system, the number of problems,
/// and switches of the window.
class TopBar : public QFrame {
  Q_OBJECT

 public:
  TopBar(const CatalogueStore& store, const LinkState& link, QWidget* parent = nullptr);

  /// The whole sentence about the GCM.
  [[nodiscard]] QString linkText() const;
  /// To the right of the logo; takes ownership.
  void addMenus(QWidget* menus);
  /// The rightmost button, the last one in the tab order of the bar.
  [[nodiscard]] QPushButton& lastButton() const { return *theme_; }

 public Q_SLOTS:
  void showProblemCount(int count);
  void showPaused(bool paused);
  /// The present time, ns since 1970, for "lost 12 s".
  void setNow(qint64 now);

 Q_SIGNALS:
  void problemsRequested();
  void pauseRequested(bool paused);
  void paletteRequested();

 private:
  void showLink();
  void addButtons();

  const CatalogueStore& store_;
  const LinkState& link_;
  std::int64_t now_ = 0;
  Pill* link_pill_;
  Pill* problem_pill_;
  QPushButton* search_;
  QPushButton* pause_;
  QPushButton* theme_;
};

}  // namespace tendon::gui
