#pragma once

#include <gcm_gui/plot/series/scaling.h>

#include <QFrame>
#include <QString>
#include <QStringList>
#include <cstdint>

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace tendon::gui {

/// A small card over the window in which the user edits scale, offset and axis of one curve, and
/// the shift in time of a recorded one. Enter applies the input; Escape or a click elsewhere
/// cancels. If an input is invalid, its field shows the reason. The card deletes itself when it is
/// closed.
class CurveEditor : public QFrame {
  Q_OBJECT

 public:
  /// `axes` are the names of the existing axes.
  CurveEditor(const QString& name, const QString& unit, const CurveLook& look,
              const QStringList& axes, QWidget* parent);
  /// Adds a field for the shift of the curve's recording, before the others.
  void addShift(std::int64_t shift_ns);

 Q_SIGNALS:
  void accepted(const tendon::gui::CurveLook& look);
  /// Emitted after accepted(), if the card has the field.
  void shiftAccepted(qint64 shift_ns);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void build(const QString& name);
  void fill(const CurveLook& look, const QStringList& axes);
  void check();
  void accept();
  bool takesKey(int key);
  /// Stores the input in `look`. Returns the reason if the input is invalid; otherwise an empty
  /// text.
  [[nodiscard]] QString read(CurveLook& look) const;
  /// Returns why the input of the shift is invalid; empty if it is valid.
  [[nodiscard]] QString refusalOfShift() const;

  const QString unit_;
  QFormLayout* fields_;
  QLineEdit* shift_ = nullptr;
  QLineEdit* factor_;
  QLineEdit* offset_;
  QComboBox* axis_;
  QLabel* status_;
  QPushButton* accept_;
};

}  // namespace tendon::gui
