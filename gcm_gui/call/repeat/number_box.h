#pragma once

#include <tendon/payload/json/number_word.h>

#include <QDoubleSpinBox>
#include <QString>

namespace tendon::gui {

/// A spin box that takes a number as it is typed, in every locale alike, and keeps what is none
/// until it is mended: letters that were swallowed would leave another number, and so would the
/// value from before.
class NumberBox : public QDoubleSpinBox {
  Q_OBJECT

 public:
  enum class Numbers { kAll, kWhole };

  explicit NumberBox(Numbers numbers, QWidget* parent = nullptr);

  /// What is wrong with what stands there, and what to write; empty where nothing is.
  [[nodiscard]] QString refusal() const;

 Q_SIGNALS:
  /// Of its text, by anyone.
  void edited();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  QValidator::State validate(QString& text, int& place) const override;
  [[nodiscard]] double valueFromText(const QString& text) const override;
  [[nodiscard]] QString textFromValue(double value) const override;

 private:
  /// Without prefix and suffix.
  [[nodiscard]] QString bareText(const QString& text) const;
  [[nodiscard]] QString refusalOf(const QString& text) const;

  Numbers numbers_;
};

}  // namespace tendon::gui
