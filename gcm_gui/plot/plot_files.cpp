#include <gcm_gui/plot/plot_files.h>

#include <gcm_gui/files/file_reader.h>
#include <gcm_gui/files/file_writer.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/plot_layout.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_picture.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/plot/series/shown_time.h>

#include <QFileDialog>
#include <memory>
#include <utility>

namespace tendon::gui {
namespace {

CsvTable InSight(const PlotView& view) {
  const TimeWindow& window = view.timeWindow();
  return CsvTableOf(view.curves(), window.firstTime(), window.lastTime(),
                    ShownWallTime() - view.now());
}

}  // namespace

PlotFiles::PlotFiles(PlotPanel& panel)
    : QObject(&panel), panel_(panel), reader_(new FileReader(this)) {
  connect(&csv_, &CsvExport::finished, this, &PlotFiles::notice);
}

void PlotFiles::askForCsv() {
  auto table = std::make_shared<CsvTable>(InSight(panel_.currentPlot()));
  if (table->empty()) {
    Q_EMIT notice(Words::tr("There is nothing to save as CSV: the plot shows no samples"));
    return;
  }
  askForFile(Words::tr("Save the visible samples as CSV"), Words::tr("CSV (*.csv)"), "csv",
             [this, table](const QString& file) { csv_.save(std::move(*table), file); });
}

void PlotFiles::askForFile(const QString& title, const QString& filter, const QString& suffix,
                           FileHandler handler) {
  auto* dialog = new QFileDialog(&panel_, title);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilter(filter);
  dialog->setDefaultSuffix(suffix);
  dialog->selectFile(panel_.tabs().title() + '.' + suffix);
  connect(dialog, &QFileDialog::fileSelected, this, std::move(handler));
  dialog->open();
}

void PlotFiles::askForPicture() {
  askForFile(Words::tr("Save a picture of the plot"), Words::tr("PNG (*.png);;SVG (*.svg)"), "png",
             [this](const QString& file) {
               SavePicture(panel_.currentPlot(), file, &panel_,
                           [this](const QString& sentence) { Q_EMIT notice(sentence); });
             });
}

void PlotFiles::askToSaveLayout() {
  askForFile(Words::tr("Save the layout of all plots"), Words::tr("Plot layout (*.plots.json)"),
             "plots.json", [this](const QString& file) { saveLayout(file); });
}

void PlotFiles::askForLayout() {
  auto* dialog = new QFileDialog(&panel_, Words::tr("Open a layout of plots"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  dialog->setNameFilter(Words::tr("Plot layout (*.plots.json *.json)"));
  connect(dialog, &QFileDialog::fileSelected, this, &PlotFiles::openLayout);
  dialog->open();
}

void PlotFiles::saveLayout(const QString& name) {
  FileWriter::instance().write(name, LayoutOf(panel_), this, [this, name](const QString& refusal) {
    Q_EMIT notice(refusal.isEmpty() ? name + Words::tr(" saved") : NotSaved(name, refusal));
  });
}

void PlotFiles::openLayout(const QString& name) {
  reader_->read(name, [this, name](const QByteArray& content, const QString& refusal) {
    if (!refusal.isEmpty()) {
      return Q_EMIT notice(name + Words::tr(" cannot be read: ") + refusal);
    }
    try {
      if (const auto reason = ShowLayout(panel_, content)) {
        Q_EMIT notice(name + Words::tr(" is not a layout of plots: ") + *reason);
      }
    } catch (...) {
      ExceptionGuard::instance().recordException(&panel_, ViewWork::kHandling);
      Q_EMIT notice(name + Words::tr(" cannot be shown: ") + CurrentExceptionText());
    }
  });
}

}  // namespace tendon::gui
