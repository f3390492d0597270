#pragma once

#include <gcm_gui/plot/series/scaling.h>

#include <QFrame>
#include <QString>
#include <QStringList>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace tendon::gui {

/// A small card over the window in which the user edits scale, offset and axis of one curve. Enter
/// applies the input; Escape or a click elsewhere cancels. If an input is invalid, its field shows
/// the reason. The card deletes itself when it is closed.
class CurveEditor : public QFrame {
  Q_OBJECT

 public:
  /// `axes` are the names of the existing axes.
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
  /// Stores the input in `look`. Returns the reason if the input is invalid; otherwise an empty
  /// text.
  [[nodiscard]] QString read(CurveLook& look) const;

  const QString unit_;
  QLineEdit* factor_;
  QLineEdit* offset_;
  QComboBox* axis_;
  QLabel* status_;
  QPushButton* accept_;
};

}  // namespace tendon::gui
