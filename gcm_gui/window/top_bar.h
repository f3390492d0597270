#pragma once

#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/link_state.h>

#include <QFrame>
#include <cstdint>

class QPushButton;

namespace tendon::gui {

class Pill;
class RecordButton;

/// The top of the window. It shows the state of the GCM, the numbers of processes, components,
/// connections and problems, and has switches for the window. In a narrower window, the switches
/// show only their icons.
class TopBar : public QFrame {
  Q_OBJECT

 public:
  TopBar(const CatalogueStore& store, const LinkState& link, QWidget* parent = nullptr);

  /// Returns the sentence about the GCM in full.
  [[nodiscard]] QString linkText() const;
  /// Adds the menus to the right of the logo. Takes ownership.
  void addMenus(QWidget* menus);
  /// Adds the button to the left of the pause button. Takes ownership.
  void addRecordButton(RecordButton* button);
  /// The rightmost button, the last one in the tab order of the bar.
  [[nodiscard]] QPushButton& lastButton() const { return *theme_; }

  /// Returns the size that the bar needs when it shows only icons.
  [[nodiscard]] QSize minimumSizeHint() const override;

 public Q_SLOTS:
  void showProblemCount(int count);
  void showPaused(bool paused);
  /// Sets the present time in ns since 1970, for texts such as "lost 12 s".
  void setNow(qint64 now);

 Q_SIGNALS:
  void problemsRequested();
  void pauseRequested(bool paused);
  void paletteRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showLink();
  void showFile();
  void addButtons();
  void showTexts();

  const CatalogueStore& store_;
  const LinkState& link_;
  std::int64_t now_ = 0;
  Pill* link_pill_;
  Pill* problem_pill_;
  QPushButton* search_;
  QPushButton* pause_;
  RecordButton* record_ = nullptr;
  QPushButton* theme_;
};

}  // namespace tendon::gui
