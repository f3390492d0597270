#pragma once

#include <tendon/payload/json/number_word.h>
#include <tendon/payload/schema.h>

#include <QLineEdit>
#include <QList>
#include <QString>
#include <QStringList>
#include <optional>

namespace tendon::gui {

/// Where one number is entered. Any text stands there as it was typed; refusal() says what is wrong
/// with it. While nobody types it shows the front of its number: what is too long for it ends with
/// an ellipsis, or is rounded where it has an exponent; the tool tip has the whole.
///
/// A list that is pasted or dropped fills the field and those behind it, or nothing at all.
class NumberField : public QLineEdit {
  Q_OBJECT

 public:
  /// Of a number, or of a list of numbers: then of one of its elements. Unit and range are those of
  /// `field`.
  explicit NumberField(const Schema::Field& field, QWidget* parent = nullptr);

  /// Which fields a list fills; this one is first.
  void setRow(const QList<NumberField*>& fields) { row_ = fields; }
  void setHelp(const QString& help);

  [[nodiscard]] NumberWord word() const;
  [[nodiscard]] bool isDuration() const { return schema_.kind() == Schema::Kind::kDuration; }
  /// Why there is no number of the type in it, and what to write; empty where there is one.
  [[nodiscard]] QString refusal() const;
  /// Why nothing was pasted; empty once anything is entered.
  [[nodiscard]] const QString& pasteRefusal() const { return paste_refusal_; }
  /// What is shown of the number while nobody types.
  [[nodiscard]] QString shownText() const;

 public Q_SLOTS:
  /// Also what the context menu calls.
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
  /// Whether `text` is a list, which is taken or refused by that.
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
