#pragma once

#include <gcm_gui/window/commands/palette_model.h>

#include <QFrame>
#include <QPointer>

class QLineEdit;

namespace tendon::gui {

class RowView;

/// A field over the window (Ctrl+K): typed words find what can be done and what there is; Enter
/// does it, or goes there. Stands in nobody's way: it leaves with Escape, and when anything else is
/// clicked.
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
  QPointer<QWidget> before_;  // had the focus
};

}  // namespace tendon::gui
