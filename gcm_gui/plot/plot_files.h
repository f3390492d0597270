#pragma once

#include <gcm_gui/plot/series/csv_export.h>

#include <QObject>
#include <QString>
#include <functional>

namespace tendon::gui {

class FileReader;
class PlotPanel;

/// Saves the samples, pictures and layouts of plots to files, and opens layouts. Files are written
/// and read in the background. GUI thread.
class PlotFiles : public QObject {
  Q_OBJECT

 public:
  /// Belongs to the panel.
  explicit PlotFiles(PlotPanel& panel);

  /// Asks for a file name, and saves all samples that were visible in the current plot when this
  /// function was called.
  void askForCsv();
  /// Asks for a file name, and saves a picture of the current plot as PNG or SVG.
  void askForPicture();
  /// Asks for a file name, and saves the layout of the plots; see LayoutOf().
  void askToSaveLayout();
  void askForLayout();
  /// Reads `file` and replaces all plots by its layout. A mistake in the file is reported by
  /// notice().
  void openLayout(const QString& file);
  void saveLayout(const QString& file);

 Q_SIGNALS:
  /// Emitted with one sentence for the user.
  void notice(const QString& text);

 private:
  using FileHandler = std::function<void(const QString& file)>;
  void askForFile(const QString& title, const QString& filter, const QString& suffix,
                  FileHandler handler);

  PlotPanel& panel_;
  CsvExport csv_;
  FileReader* reader_;
};

}  // namespace tendon::gui
