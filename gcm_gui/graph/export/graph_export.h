#pragma once

#include <gcm_gui/files/background.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/courier.h>

#include <QObject>
#include <QString>
#include <functional>
#include <memory>

class QWidget;

namespace tendon::gui {

class GraphScene;

/// All of the graph as a file: SVG and DOT as `gcm graph` draws them, but arranged as in the window
/// where the user has put something somewhere; PNG as the window draws it. GUI thread; files are
/// drawn and written by the FileWriter, the picture for the clipboard is drawn in a thread of its
/// own.
class GraphExport : public QObject {
  Q_OBJECT

 public:
  /// Dialogs belong to `window`.
  GraphExport(const CatalogueStore& store, GraphScene& scene, QWidget& window);
  /// Waits for what is being drawn for the clipboard, though not for ever.
  ~GraphExport() override;

  /// What the file is, its name's end tells: .svg, .png, .dot or .gv.
  void save(const QString& file);

 public Q_SLOTS:
  /// For the name of the file.
  void ask();
  /// The picture, to the clipboard.
  void copy();

 Q_SIGNALS:
  /// One sentence for the user: what was saved, or why not.
  void notice(const QString& text);

 private:
  using Draw = std::function<QByteArray()>;

  void write(const QString& file, Draw draw);

  const CatalogueStore& store_;
  GraphScene& scene_;
  QWidget& window_;
  std::shared_ptr<Courier> courier_;
  Background thread_{QT_TRANSLATE_NOOP("Words", "a picture for the clipboard")};
};

}  // namespace tendon::gui
