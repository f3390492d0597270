#pragma once

#include <gcm_gui/files/background.h>
#include <gcm_gui/files/gui_poster.h>
#include <gcm_gui/session/catalogue_store.h>

#include <QObject>
#include <QString>
#include <functional>
#include <memory>

class QWidget;

namespace tendon::gui {

class GraphScene;

/// Exports the whole graph. SVG and DOT files look like the output of `gcm graph`, but use the
/// positions of the window if the user has moved components. PNG files look like the graph in the
/// window. GUI thread. The FileWriter draws and writes files in its thread; another thread draws
/// the picture for the clipboard.
class GraphExport : public QObject {
  Q_OBJECT

 public:
  /// `window` is the parent of dialogs.
  GraphExport(const CatalogueStore& store, GraphScene& scene, QWidget& window);
  /// Waits for a limited time until the picture for the clipboard is drawn.
  ~GraphExport() override;

  /// Saves the graph. The suffix of the name selects the format: .svg, .png, .dot or .gv.
  void save(const QString& file);

 public Q_SLOTS:
  /// Asks the user for the name of the file, and saves the graph.
  void ask();
  /// Copies a picture of the graph to the clipboard.
  void copy();

 Q_SIGNALS:
  /// Emitted with one sentence for the user: the name of the saved file, or why saving failed.
  void notice(const QString& text);

 private:
  using Draw = std::function<QByteArray()>;

  void write(const QString& file, Draw draw);

  const CatalogueStore& store_;
  GraphScene& scene_;
  QWidget& window_;
  std::shared_ptr<GuiPoster> poster_;
  Background thread_{QT_TRANSLATE_NOOP("Words", "a picture for the clipboard")};
};

}  // namespace tendon::gui
