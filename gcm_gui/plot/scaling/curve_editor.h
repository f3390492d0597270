#pragma once

#include <gcm_gui/plot/scaling/scaling.h>

#include <QFrame>
#include <QString>
#include <QStringList>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace tendon::gui {

/// Scale, offset and axis of one curve, in a small card over the window: Enter takes them, Escape
/// and a click elsewhere leave all as it was. What cannot be shown is refused where it is typed,
/// and why. Deletes itself when it is closed.
class CurveEditor : public QFrame {
  Q_OBJECT

 public:
  /// `axes` are the names of those there are.
  CurveEditor(const QString& name, const QString& unit, const CurveLook& look,
              const QStringList& axes, QWidget* parent);

 Q_SIGNALS:
  void accepted(const tendon::gui::CurveLook& look);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void build(const QString& name);
  void fill(const CurveLook& look, const QStringList& axes);
  void check();
  void accept();
  bool takesKey(int key);
  /// Empty where `look` holds what was typed.
  [[nodiscard]] QString read(CurveLook& look) const;

  const QString unit_;
  QLineEdit* factor_;
  QLineEdit* offset_;
  QComboBox* axis_;
  QLabel* status_;
  QPushButton* accept_;
};

}  // namespace tendon::gui
