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

/// Exports the whole graph: SVG and DOT as `gcm graph` draws them, but with the window's
/// arrangement if the user has moved something; PNG as the window draws it. GUI thread. The
/// FileWriter draws and writes files; a separate thread draws the picture for the clipboard.
class GraphExport : public QObject {
  Q_OBJECT

 public:
  /// `window` is the parent of dialogs.
  GraphExport(const CatalogueStore& store, GraphScene& scene, QWidget& window);
  /// Waits, for a limited time, for the picture that is being drawn for the clipboard.
  ~GraphExport() override;

  /// The suffix of the name selects the format: .svg, .png, .dot or .gv.
  void save(const QString& file);

 public Q_SLOTS:
  /// Asks for the name of the file.
  void ask();
  /// Copies the picture to the clipboard.
  void copy();

 Q_SIGNALS:
  /// A sentence for the user: the saved file, or the reason of the failure.
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
