#include <gcm_gui/plot/layout/plot_layout.h>
#include <gcm_gui/plot/picture/plot_picture.h>
#include <gcm_gui/plot/plot_head.h>
#include <gcm_gui/plot/plot_menu.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>

#include <QFile>
#include <QFileDialog>
#include <QInputDialog>
#include <QMenu>
#include <QSaveFile>
#include <QSet>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

namespace tendon::gui {
namespace {

constexpr int kHeadPeriod = 250;  // ms

CsvTable InSight(const PlotView& view) {
  const std::chrono::nanoseconds utc = std::chrono::system_clock::now().time_since_epoch();
  const TimeWindow& window = view.window();
  return CsvTableOf(view.curves(), window.timeAt(window.from()), window.timeAt(window.to()),
                    utc.count() - view.now());
}

}  // namespace

PlotPanel::PlotPanel(QWidget* parent)
    : QWidget(parent), head_(new PlotHead(this)), plots_(new QStackedWidget(this)) {
  setObjectName("plotPanel");
  setAccessibleName("Plots");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(head_);
  column->addWidget(plots_, 1);
  buildTabs();
  connect(head_, &PlotHead::newPlotRequested, this, [this] { addPlot(); });
  connect(head_, &PlotHead::windowChosen, this, &PlotPanel::setWindow);
  connect(head_, &PlotHead::pauseToggled, this, &PlotPanel::setPaused);
  connect(head_, &PlotHead::cursorsToggled, this,
          [this](bool shown) { currentPlot().showCursors(shown); });
  connect(head_, &PlotHead::csvRequested, this, &PlotPanel::askForCsv);
  connect(&csv_, &CsvExport::finished, this, &PlotPanel::notice);
  connect(&head_timer_, &QTimer::timeout, this, &PlotPanel::updateHead);
  head_timer_.start(kHeadPeriod);
  addPlot();
}

void PlotPanel::buildTabs() {
  QTabBar& tabs = head_->tabs();
  tabs.setContextMenuPolicy(Qt::CustomContextMenu);
  connect(&tabs, &QTabBar::currentChanged, this, &PlotPanel::showPlot);
  connect(&tabs, &QWidget::customContextMenuRequested, this, &PlotPanel::showTabMenu);
}

PlotView& PlotPanel::addPlot() {
  auto* view = new PlotView(plots_);
  view->setPaused(paused_);
  view->setMarks(marks_);
  connect(view, &PlotView::curvesDropped, this, [this, view](const QList<CurveKey>& keys) {
    for (const CurveKey& key : keys) add(*view, key);
  });
  connect(view, &PlotView::curveRemovalRequested, this,
          [this, view](const QString& path) { removeFrom(*view, path); });
  connect(view, &PlotView::liveChanged, this, [this](bool live) {
    if (live) setPaused(false);
  });
  connect(view, &PlotView::cursorsChanged, this, &PlotPanel::updateHead);
  connect(view, &PlotView::remapRequested, this, &PlotPanel::askForRemap);
  connect(view, &PlotView::menuRequested, this,
          [this, view](const QPoint& position) { showPlotMenu(*view, position); });
  plots_->addWidget(view);
  const int index = head_->tabs().addTab({});
  nameTab(*view);
  head_->tabs().setCurrentIndex(index);
  showPlot(index);
  return *view;
}

void PlotPanel::closePlot(int index) {
  PlotView& view = plot(index);
  QStringList paths;
  for (const auto& curve : view.curves().curves()) paths << curve->path();
  for (const QString& path : paths) removeFrom(view, path);
  if (plotCount() == 1) return;
  head_->tabs().removeTab(index);
  plots_->removeWidget(&view);
  view.deleteLater();
  showPlot(head_->tabs().currentIndex());
}

void PlotPanel::showTabMenu(const QPoint& position) {
  const int index = head_->tabs().tabAt(position);
  if (index < 0) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction("Close plot", this, [this, index] { closePlot(index); });
  menu->popup(head_->tabs().mapToGlobal(position));
}

void PlotPanel::showPlot(int index) {
  head_->tabs().setCurrentIndex(index);
  plots_->setCurrentIndex(index);
  updateHead();
}

// By the column of its first curve; by its number while it is empty.
void PlotPanel::nameTab(const PlotView& view) {
  const int index = plots_->indexOf(&view);
  const auto& curves = view.curves().curves();
  const QString name =
      curves.empty() ? QString("Plot %1").arg(index + 1) : ColumnOf(curves.front()->path());
  head_->tabs().setTabText(index, name);
  plot(index).setAccessibleName("Plot " + name);
}

PlotView& PlotPanel::plot(int index) const {
  return static_cast<PlotView&>(*plots_->widget(index));
}

int PlotPanel::plotCount() const { return plots_->count(); }

int PlotPanel::currentIndex() const { return plots_->currentIndex(); }

void PlotPanel::addSignal(const QString& path, const QString& unit) {
  add(currentPlot(), {.path = path, .unit = unit});
}

void PlotPanel::add(PlotView& view, const CurveKey& key) {
  if (view.curve(key.path) != nullptr) return;
  const bool wanted = !isPlotted(key.path);
  view.addCurve(key);
  shareMemory();
  nameTab(view);
  updateHead();
  if (wanted) Q_EMIT subscriptionWanted(key.path);
}

void PlotPanel::removeSignal(const QString& path) {
  for (int i = 0; i < plotCount(); ++i) removeFrom(plot(i), path);
}

void PlotPanel::removeFrom(PlotView& view, const QString& given) {
  if (view.curve(given) == nullptr) return;
  const QString path = given;  // may be the curve's own
  view.removeCurve(path);
  shareMemory();
  nameTab(view);
  updateHead();
  if (!isPlotted(path)) Q_EMIT subscriptionReleased(path);
}

bool PlotPanel::isPlotted(const QString& path) const { return paths().contains(path); }

QStringList PlotPanel::paths() const {
  QStringList paths;
  for (int i = 0; i < plotCount(); ++i) {
    for (const auto& curve : plot(i).curves().curves()) {
      if (!paths.contains(curve->path())) paths << curve->path();
    }
  }
  return paths;
}

void PlotPanel::append(const QString& path, std::span<const Sample> samples) {
  for (int i = 0; i < plotCount(); ++i) {
    if (Curve* curve = plot(i).curve(path)) curve->append(samples);
  }
}

void PlotPanel::addMark(Mark mark) {
  marks_.add(std::move(mark));
  for (int i = 0; i < plotCount(); ++i) plot(i).marksChanged();
}

void PlotPanel::beginEpoch(const QString& path) {
  for (int i = 0; i < plotCount(); ++i) {
    if (Curve* curve = plot(i).curve(path)) curve->beginEpoch();
  }
}

void PlotPanel::setStale(const QString& path, const QString& reason) {
  for (int i = 0; i < plotCount(); ++i) {
    Curve* curve = plot(i).curve(path);
    if (curve != nullptr) curve->setStale(reason.isEmpty() ? WaitingFor(path) : reason);
  }
}

void PlotPanel::setPaused(bool paused) {
  if (paused == paused_) return;
  paused_ = paused;
  for (int i = 0; i < plotCount(); ++i) plot(i).setPaused(paused);
  head_->setPaused(paused);
  Q_EMIT pausedChanged(paused);
}

void PlotPanel::setWindow(std::chrono::nanoseconds length) {
  currentPlot().setWindow(length);
  updateHead();
}

void PlotPanel::askForCsv() {
  auto table = std::make_shared<CsvTable>(InSight(currentPlot()));
  if (table->empty()) {
    Q_EMIT notice("There is nothing to save as CSV: the plot shows no samples");
    return;
  }
  askForFile("Save what is seen as CSV", "CSV (*.csv)", "csv",
             [this, table](const QString& file) { csv_.save(std::move(*table), file); });
}

void PlotPanel::askForFile(const QString& title, const QString& filter, const QString& suffix,
                           FileHandler handler) {
  auto* dialog = new QFileDialog(this, title);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilter(filter);
  dialog->setDefaultSuffix(suffix);
  dialog->selectFile(head_->tabs().tabText(currentIndex()) + '.' + suffix);
  connect(dialog, &QFileDialog::fileSelected, this, std::move(handler));
  dialog->open();
}

void PlotPanel::askForPicture() {
  askForFile("Save a picture of the plot", "PNG (*.png);;SVG (*.svg)", "png",
             [this](const QString& file) { Q_EMIT notice(SavePicture(currentPlot(), file)); });
}

void PlotPanel::askToSaveLayout() {
  askForFile("Save the layout of all plots", "Plot layout (*.plots.json)", "plots.json",
             [this](const QString& file) { saveLayout(file); });
}

void PlotPanel::askForLayout() {
  auto* dialog = new QFileDialog(this, "Open a layout of plots");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  dialog->setNameFilter("Plot layout (*.plots.json *.json)");
  connect(dialog, &QFileDialog::fileSelected, this, &PlotPanel::openLayout);
  dialog->open();
}

void PlotPanel::saveLayout(const QString& name) {
  QSaveFile file(name);
  if (file.open(QIODevice::WriteOnly) && file.write(LayoutOf(*this)) >= 0 && file.commit()) {
    return Q_EMIT notice(name + " saved");
  }
  Q_EMIT notice(name + " was not saved: " + file.errorString());
}

void PlotPanel::openLayout(const QString& name) {
  QFile file(name);
  if (!file.open(QIODevice::ReadOnly)) {
    return Q_EMIT notice(name + " cannot be read: " + file.errorString());
  }
  if (const auto reason = ShowLayout(*this, file.readAll())) {
    Q_EMIT notice(name + " is no layout of plots: " + *reason);
  }
}

void PlotPanel::setCandidates(std::function<QList<CurveKey>(const QString& path)> candidates) {
  candidates_ = std::move(candidates);
}

void PlotPanel::askForRemap(const QString& path) {
  const QList<CurveKey> candidates = candidates_ ? candidates_(path) : QList<CurveKey>();
  QStringList names;
  for (const CurveKey& key : candidates) names << key.path;
  auto* dialog = new QInputDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle("Show another signal");
  dialog->setLabelText("In place of " + path);
  dialog->setComboBoxItems(names);
  dialog->setComboBoxEditable(true);
  dialog->setTextValue(names.isEmpty() ? path : names.front());
  connect(dialog, &QInputDialog::textValueSelected, this,
          [this, path, candidates](const QString& chosen) {
            for (const CurveKey& key : candidates) {
              if (key.path == chosen) return remap(path, key);
            }
            const Curve* curve = currentPlot().curve(path);
            remap(path, {chosen, curve != nullptr ? curve->unit() : QString()});
          });
  dialog->open();
}

void PlotPanel::remap(const QString& given, const CurveKey& to) {
  const QString from = given;  // may be a curve's own
  if (from == to.path || to.path.isEmpty()) return;
  for (int i = 0; i < plotCount(); ++i) {
    if (plot(i).curve(from) == nullptr) continue;
    add(plot(i), to);
    removeFrom(plot(i), from);
  }
}

void PlotPanel::showPlotMenu(PlotView& view, const QPoint& position) {
  auto* menu = new QMenu(this);
  menu->setObjectName("plotMenu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  FillPlotMenu(*menu, *this, view);
  menu->popup(view.canvas()->mapToGlobal(position));
}

void PlotPanel::toggleCursors() { currentPlot().showCursors(!currentPlot().cursors().any()); }

void PlotPanel::setMemoryBudget(std::size_t bytes) {
  memory_ = bytes;
  shareMemory();
}

void PlotPanel::shareMemory() {
  std::size_t count = 0;
  for (int i = 0; i < plotCount(); ++i) count += plot(i).curves().curves().size();
  const std::size_t budget = memory_ / std::max<std::size_t>(count, 1);
  for (int i = 0; i < plotCount(); ++i) {
    for (const auto& curve : plot(i).curves().curves()) curve->setBudget(budget);
  }
}

void PlotPanel::updateHead() {
  if (plotCount() == 0) return;
  std::size_t used = 0;
  bool is_thinned = false;
  for (int i = 0; i < plotCount(); ++i) {
    for (const auto& curve : plot(i).curves().curves()) {
      used += curve->bytes();
      is_thinned = is_thinned || curve->isThinned();
    }
  }
  head_->setMemory(used, memory_, is_thinned);
  head_->setFigures(currentPlot().figures());
  head_->setWindow(currentPlot().window().length());
  head_->setCursors(currentPlot().cursors().any());
}

}  // namespace tendon::gui
