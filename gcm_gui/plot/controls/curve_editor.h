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

/// Edits scale, offset and axis of one curve on a small card over the window. Enter applies; Escape
/// or a click elsewhere cancels. Invalid input is refused at its field, with the reason. Deletes
/// itself when closed.
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
  /// Fills `look` with the input; returns the reason why it is invalid, or an empty text.
  [[nodiscard]] QString read(CurveLook& look) const;

  const QString unit_;
  QLineEdit* factor_;
  QLineEdit* offset_;
  QComboBox* axis_;
  QLabel* status_;
  QPushButton* accept_;
};

}  // namespace tendon::gui
