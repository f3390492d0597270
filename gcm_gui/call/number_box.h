#pragma once

#include <tendon/payload/json/number_literal.h>

#include <QDoubleSpinBox>
#include <QString>

namespace tendon::gui {

/// A spin box that keeps the number as typed, in every locale. An invalid text stays until the user
/// corrects it: removing letters or restoring the old value would silently change the number.
class NumberBox : public QDoubleSpinBox {
  Q_OBJECT

 public:
  enum class Numbers { kAll, kWhole };

  explicit NumberBox(Numbers numbers, QWidget* parent = nullptr);

  /// Returns the mistake in the text and what to write instead; empty if the text is valid.
  [[nodiscard]] QString refusal() const;

 Q_SIGNALS:
  /// Emitted when the user or the program has changed the text.
  void edited();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  QValidator::State validate(QString& text, int& place) const override;
  [[nodiscard]] double valueFromText(const QString& text) const override;
  [[nodiscard]] QString textFromValue(double value) const override;

 private:
  /// Returns `text` without prefix and suffix.
  [[nodiscard]] QString bareText(const QString& text) const;
  [[nodiscard]] QString refusalOf(const QString& text) const;

  Numbers numbers_;
};

}  // namespace tendon::gui
