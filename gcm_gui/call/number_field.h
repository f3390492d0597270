#pragma once

#include <tendon/payload/json/number_literal.h>
#include <tendon/payload/schema.h>

#include <QLineEdit>
#include <QList>
#include <QString>
#include <QStringList>
#include <optional>

namespace tendon::gui {

/// The editor of one number. It keeps any text as typed; refusal() reports a mistake in it. Without
/// the focus it shows the beginning of a long number, with an ellipsis, or rounds a number with an
/// exponent; the tool tip has the whole number.
///
/// A pasted or dropped list fills this field and the following ones completely, or no field.
class NumberField : public QLineEdit {
  Q_OBJECT

 public:
  /// For a number, or for one element of a list of numbers. `field` gives unit and range.
  explicit NumberField(const Schema::Field& field, QWidget* parent = nullptr);

  /// The fields that a list fills, beginning with this one.
  void setRow(const QList<NumberField*>& fields) { row_ = fields; }
  void setHelp(const QString& help);

  [[nodiscard]] NumberLiteral word() const;
  [[nodiscard]] bool isDuration() const { return schema_.kind() == Schema::Kind::kDuration; }
  /// The reason why the text is not a number of the type, and what to write; empty if it is valid.
  [[nodiscard]] QString refusal() const;
  /// The reason why nothing was pasted; empty after any input.
  [[nodiscard]] const QString& pasteRefusal() const { return paste_refusal_; }
  /// The text shown without the focus.
  [[nodiscard]] QString shownText() const;

 public Q_SLOTS:
  /// Pastes the clipboard; the context menu calls it too.
  void paste();

 Q_SIGNALS:
  void pasteRefused();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  /// Returns true if `text` is a list; then the list has been accepted or refused.
  bool takeList(const QString& text);
  [[nodiscard]] QString refusalOfList(const QStringList& words) const;
  [[nodiscard]] QRect contents() const;
  void showChange();

  Schema schema_;
  QString unit_;
  std::optional<Range> range_;
  QString help_;
  QList<NumberField*> row_;
  QString paste_refusal_;
};

}  // namespace tendon::gui
