#pragma once

#include <gcm_gui/theme/state_mark.h>

#include <QString>
#include <QWidget>

namespace tendon::gui {

/// A mark and its word, in the state's colour.
class StateLabel : public QWidget {
  Q_OBJECT

 public:
  explicit StateLabel(QWidget* parent = nullptr);

  /// Shows a mark with this text. If the text is empty, shows the default word of the mark.
  void show(StateMark mark, const QString& text = {});
  /// If true, the label is grey, because it shows the last known state.
  void setStale(bool stale);
  [[nodiscard]] const QString& text() const { return text_; }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  StateMark mark_ = StateMark::kReady;
  bool stale_ = false;
  QString text_;
};

}  // namespace tendon::gui
