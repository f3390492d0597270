#pragma once

#include <tendon/payload/json/number_literal.h>
#include <tendon/payload/schema.h>

#include <QLineEdit>
#include <QList>
#include <QString>
#include <QStringList>
#include <optional>

namespace tendon::gui {

/// Edits one number. The field keeps any text as typed; refusal() reports a mistake in it. Without
/// the focus, the field shows only the beginning of a long number, with an ellipsis, and rounds a
/// number with an exponent. The tool tip then contains the whole number.
///
/// If the user pastes or drops a list, either this field and the following fields take all its
/// numbers, or no field changes.
class NumberField : public QLineEdit {
  Q_OBJECT

 public:
  /// Edits a number, or one element of a list of numbers. `field` defines unit and range.
  explicit NumberField(const Schema::Field& field, QWidget* parent = nullptr);

  /// Sets the fields into which a list is pasted; this field is the first of them.
  void setRow(const QList<NumberField*>& fields) { row_ = fields; }
  void setHelp(const QString& help);

  [[nodiscard]] NumberLiteral word() const;
  [[nodiscard]] bool isDuration() const { return schema_.kind() == Schema::Kind::kDuration; }
  /// Returns why the text is not a number of the field's type, and what to write instead. Empty if
  /// the text is valid.
  [[nodiscard]] QString refusal() const;
  /// Returns why a list was not pasted; empty again after any input.
  [[nodiscard]] const QString& pasteRefusal() const { return paste_refusal_; }
  /// Returns the text that is shown without the focus.
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
  /// Fills the fields if `text` is a list. Returns true for a list, even if the list is refused.
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
