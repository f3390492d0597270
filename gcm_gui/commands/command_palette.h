#pragma once

#include <gcm_gui/commands/palette_model.h>

#include <QFrame>
#include <QPointer>

class QLineEdit;

namespace tendon::gui {

class RowView;

/// A search field over the window (Ctrl+K) for commands and objects; Enter runs the command or goes
/// to the object. Closes on Escape and when the user clicks anything else.
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
  QPointer<QWidget> before_;  // had the focus before
};

}  // namespace tendon::gui
