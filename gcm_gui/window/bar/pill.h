#pragma once

#include <gcm_gui/theme/state_mark.h>

#include <QAbstractButton>
#include <QString>

namespace tendon::gui {

/// A raised field of the top bar: a mark, strong words, and dim ones behind them. May be clicked.
class Pill : public QAbstractButton {
  Q_OBJECT

 public:
  explicit Pill(QWidget* parent = nullptr);

  void show(StateMark mark, const QString& strong, const QString& dim = {});
  [[nodiscard]] QString spoken() const { return strong_ + ' ' + dim_; }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  StateMark mark_ = StateMark::kConnecting;
  QString strong_;
  QString dim_;
};

}  // namespace tendon::gui
