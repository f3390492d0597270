#pragma once

#include <gcm_gui/commands/palette_model.h>

#include <QFrame>
#include <QPointer>

class QLineEdit;

namespace tendon::gui {

class RowView;

/// A search field over the window (Ctrl+K) that finds commands and objects. Enter runs the selected
/// command or goes to the selected object. Escape or a click elsewhere closes the palette.
class CommandPalette : public QFrame {
  Q_OBJECT

 public:
  CommandPalette(QList<QAction*> actions, const CatalogueModel& catalogue, QWidget& window);

  void open();

 Q_SIGNALS:
  void pathChosen(const QString& path);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void find(const QString& words);
  void leave();
  void choose(const QModelIndex& index);
  bool press(int key);

  PaletteModel model_;
  QLineEdit* field_;
  RowView* list_;
  QPointer<QWidget> before_;  // the widget that had the focus before
};

}  // namespace tendon::gui
