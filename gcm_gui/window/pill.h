#pragma once

#include <gcm_gui/theme/state_mark.h>

#include <QAbstractButton>
#include <QString>

namespace tendon::gui {

/// A raised field in the top bar. It shows a mark, strong words, and as many of the dim words as
/// fit. The user may click it.
class Pill : public QAbstractButton {
  Q_OBJECT

 public:
  explicit Pill(QWidget* parent = nullptr);

  void show(StateMark mark, const QString& strong, const QString& dim = {});
  [[nodiscard]] QString spoken() const { return strong_ + ' ' + dim_; }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeWith({}); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QSize sizeWith(const QString& dim) const;
  [[nodiscard]] QString shortened(int width) const;

  StateMark mark_ = StateMark::kPending;
  QString strong_;
  QString dim_;
};

}  // namespace tendon::gui
