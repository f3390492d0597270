#include <gcm_gui/plot/plot_panel.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/controls/plot_header.h>
#include <gcm_gui/plot/controls/plot_menu.h>
#include <gcm_gui/plot/plot_files.h>
#include <gcm_gui/plot/plot_page.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/plot/series/time_shift.h>

#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>
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

}  // namespace

PlotPanel::PlotPanel(QWidget* parent, std::size_t memory)
    : QWidget(parent),
      head_(new PlotHeader(this)),
      pages_(new QStackedWidget(this)),
      tabs_(head_->tabs(), *pages_),
      files_(new PlotFiles(*this)),
      memory_(memory) {
  setObjectName("plotPanel");
  setAccessibleName(Words::tr("Plots"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(head_);
  column->addWidget(pages_, 1);
  buildTabs();
  connectHead();
  connect(files_, &PlotFiles::notice, this, &PlotPanel::notice);
  connect(&head_timer_, &QTimer::timeout, this, Guarded(this, &PlotPanel::updateHead));
  head_timer_.start(kHeadPeriod);
  addPlot();
}

void PlotPanel::connectHead() {
  connect(head_, &PlotHeader::newPlotRequested, this, [this] { addPlot(); });
  connect(head_, &PlotHeader::splitRequested, this, [this] { splitPlot(); });
  connect(head_, &PlotHeader::backRequested, this, [this] { currentPlot().gestures().goBack(); });
  connect(head_, &PlotHeader::forwardRequested, this,
          [this] { currentPlot().gestures().goForward(); });
  connect(head_, &PlotHeader::sweepToggled, this, [this](bool sweeping) {
    currentPlot().setMotion(sweeping ? TimeWindow::Motion::kSweep : TimeWindow::Motion::kScroll);
  });
  connect(head_, &PlotHeader::windowChosen, this, &PlotPanel::setWindow);
  connect(head_, &PlotHeader::pauseToggled, this, &PlotPanel::setPaused);
  connect(head_, &PlotHeader::cursorsToggled, this,
          [this](bool shown) { currentPlot().cursors().show(shown); });
  connect(head_, &PlotHeader::csvRequested, files_, &PlotFiles::askForCsv);
}

void PlotPanel::buildTabs() {
  QTabBar& tabs = head_->tabs();
  tabs.setContextMenuPolicy(Qt::CustomContextMenu);
  connect(&tabs, &QTabBar::currentChanged, this, &PlotPanel::showPage);
  connect(&tabs, &QWidget::customContextMenuRequested, this, &PlotPanel::showTabMenu);
}

void PlotPanel::prepare(PlotView& given) {
  PlotView* view = &given;
  if (paused_) view->setPaused(true);
  view->marks().set(marks_);
  view->marks().setShown(marks_shown_);
  connect(view, &PlotView::curvesDropped, this, [this, view](const QList<CurveKey>& keys) {
    for (const CurveKey& key : keys) add(*view, key);
  });
  connect(&view->recordedCurves(), &RecordedCurves::moved, this,
          [this](const QString& recording, qint64 shift_ns) {
            Q_EMIT notice(Words::tr("%1 is shifted by %2; Alt+Left undoes the shift")
                              .arg(QFileInfo(recording).fileName(), RoundedShiftText(shift_ns)));
          });
  connect(view, &PlotView::curvesMoved, this,
          [this, view](const QList<CurveKey>& keys, quint64 from) {
            for (const CurveKey& key : keys) move(key.path, from, *view);
          });
  connect(view, &PlotView::curveRemovalRequested, this,
          [this, view](const QString& path) { removeFrom(*view, path); });
  connect(view, &PlotView::liveChanged, this, [this](bool live) {
    if (live) setPaused(false);
  });
  connect(&view->cursors(), &PlotCursors::shownChanged, this, &PlotPanel::updateHead);
  connect(view, &PlotView::motionChanged, this, &PlotPanel::updateHead);
  connect(view, &PlotView::marksToggled, this, [this] { setMarksShown(!marks_shown_); });
  connect(view, &PlotView::remapRequested, this, &PlotPanel::askForRemap);
  connect(view, &PlotView::menuRequested, this, [this, view](const QPoint& position) {
    tabs_.pageOf(*view).setCurrent(*view);
    showPlotMenu(*view, position);
  });
}

void PlotPanel::addSignal(const QString& path, const QString& unit) {
  add(currentPlot(), {.path = path, .unit = unit});
}

void PlotPanel::add(PlotView& view, const CurveKey& key) {
  if (view.curve(key.path) != nullptr) return;
  const bool wanted = !isPlotted(key.path);
  const ValueNamesPointer names = namesOf(key.path);
  view.addCurve(key);
  view.setNames(key.path, names);
  Curve& curve = *view.curve(key.path);
  const auto time = recorded_times_.find(curve.recording());
  if (time != recorded_times_.end()) curve.setRecordedEnd(time->second.to_ns);
  if (losses_ && !curve.isRecorded()) curve.setLossesBefore(losses_(key.path));
  shareMemory();
  tabs_.update(tabs_.pageOf(view));
  updateHead();
  if (wanted) Q_EMIT subscriptionWanted(key.path);
}

void PlotPanel::removeFrom(PlotView& view, const QString& given) {
  if (view.curve(given) == nullptr) return;
  const QString path = given;  // a copy, because `given` may refer to the path in the curve itself
  view.removeCurve(path);
  shareMemory();
  tabs_.update(tabs_.pageOf(view));
  updateHead();
  if (!isPlotted(path)) Q_EMIT subscriptionReleased(path);
}

// Returns the names of the values of this signal, from any plot that shows the signal. The source
// announces these names only once.
ValueNamesPointer PlotPanel::namesOf(const QString& path) const {
  for (const PlotView* view : tabs_.plots()) {
    if (const Curve* curve = view->curve(path)) return curve->allNames();
  }
  return nullptr;
}

bool PlotPanel::isPlotted(const QString& path) const {
  const std::vector<PlotView*> all = tabs_.plots();
  return std::any_of(all.begin(), all.end(),
                     [&](const PlotView* view) { return view->curve(path) != nullptr; });
}

QStringList PlotPanel::paths() const {
  QStringList paths;
  for (PlotView* view : tabs_.plots()) {
    for (const auto& curve : view->curves().curves()) {
      if (!curve->isRecorded() && !paths.contains(curve->path())) paths << curve->path();
    }
  }
  return paths;
}

void PlotPanel::append(const QString& path, std::span<const Sample> samples) {
  for (PlotView* view : tabs_.plots()) {
    Curve* curve = view->curve(path);
    if (curve == nullptr) continue;
    curve->append(samples);
    // New samples of a recorded curve do not cause a redraw by themselves.
    if (curve->isRecorded()) view->requestRedraw();
  }
}

void PlotPanel::setNames(const QString& path, const ValueNamesPointer& names) {
  for (PlotView* view : tabs_.plots()) view->setNames(path, names);
}

void PlotPanel::addMark(Mark mark) {
  marks_.add(std::move(mark));
  for (PlotView* view : tabs_.plots()) view->requestRedraw();
}

void PlotPanel::removeMarks() {
  marks_.clear();
  for (PlotView* view : tabs_.plots()) view->requestRedraw();
}

void PlotPanel::setMarksShown(bool shown) {
  if (shown == marks_shown_) return;
  marks_shown_ = shown;
  for (PlotView* view : tabs_.plots()) view->marks().setShown(shown);
  Q_EMIT marksShownChanged(shown);
}

void PlotPanel::removeSamples(const QString& recording) {
  for (PlotView* view : tabs_.plots()) {
    for (const auto& curve : view->curves().curves()) {
      if (curve->recording() == recording) curve->removeSamples();
    }
    view->requestRedraw();
  }
}

void PlotPanel::setRecordedTime(const QString& recording, const TimeSpan& time) {
  recorded_times_[recording] = time;
  for (PlotView* view : tabs_.plots()) {
    for (const auto& curve : view->curves().curves()) {
      if (curve->recording() == recording) curve->setRecordedEnd(time.to_ns);
    }
    view->requestRedraw();
  }
}

void PlotPanel::showBegin(PlotView& view, const QString& recording) {
  const auto time = recorded_times_.find(recording);
  if (time != recorded_times_.end()) {
    view.recordedCurves().align(recording, time->second.from_ns, RecordedCurves::Edge::kLeft);
  }
}

std::optional<TimeSpan> PlotPanel::seenOf(const QString& recording) const {
  for (PlotView* view : tabs_.currentPage().views()) {
    if (!view->recordedCurves().recordings().contains(recording)) continue;
    const std::int64_t back_ns = -view->recordedCurves().shift(recording);
    return TimeSpan{.from_ns = MovedTime(view->timeWindow().firstTime(), back_ns),
                    .to_ns = MovedTime(view->timeWindow().lastTime(), back_ns)};
  }
  return std::nullopt;
}

void PlotPanel::beginEpoch(const QString& path) {
  for (PlotView* view : tabs_.plots()) {
    if (Curve* curve = view->curve(path)) curve->beginEpoch();
  }
}

void PlotPanel::setStale(const QString& path, const QString& reason) {
  for (PlotView* view : tabs_.plots()) {
    Curve* curve = view->curve(path);
    if (curve != nullptr) curve->setStale(reason.isEmpty() ? WaitingFor(path) : reason);
  }
}

void PlotPanel::setStandstills(Standstills standstills) {
  standstills_ = std::move(standstills);
  updateStandstills();
}

void PlotPanel::updateStandstills() {
  if (!standstills_) return;
  for (PlotView* view : tabs_.plots()) {
    for (const auto& curve : view->curves().curves()) {
      if (curve->isRecorded()) continue;
      const SampleRing& samples = curve->samples();
      const auto newest =
          samples.empty() ? std::nullopt : std::optional(samples.time(samples.endIndex() - 1));
      const QString why = standstills_(curve->path(), newest);
      if (why == curve->standstill()) continue;
      curve->setStandstill(why);
      view->requestRedraw();
    }
  }
}

void PlotPanel::setPaused(bool paused) {
  if (paused == paused_) return;
  paused_ = paused;
  for (PlotView* view : tabs_.plots()) view->setPaused(paused);
  head_->setPaused(paused);
  Q_EMIT pausedChanged(paused);
}

void PlotPanel::setWindow(std::chrono::nanoseconds length) {
  currentPlot().setWindow(length);
  updateHead();
}

void PlotPanel::setCandidates(std::function<QList<CurveKey>(const QString& path)> candidates) {
  candidates_ = std::move(candidates);
}

void PlotPanel::setLosses(std::function<RowLosses(const QString& path)> losses) {
  losses_ = std::move(losses);
}

void PlotPanel::askForRemap(const QString& path) {
  const QList<CurveKey> candidates = candidates_ ? candidates_(path) : QList<CurveKey>();
  QStringList names;
  for (const CurveKey& key : candidates) names << key.path;
  auto* dialog = new QInputDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(Words::tr("Show another signal"));
  dialog->setLabelText(Words::tr("In place of ") + path);
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
  // Copied, because `given` may refer to the path of a curve that this function removes.
  const QString from = given;
  if (from == to.path || to.path.isEmpty()) return;
  for (PlotView* view : tabs_.plots()) {
    if (view->curve(from) == nullptr) continue;
    const CurveLook look = view->curve(from)->look();
    const bool is_new = view->curve(to.path) == nullptr;
    add(*view, to);
    if (is_new) view->setLook(to.path, look);
    removeFrom(*view, from);
  }
}

void PlotPanel::showPlotMenu(PlotView& view, const QPoint& position) {
  auto* menu = new QMenu(this);
  menu->setObjectName("plotMenu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  FillPlotMenu(*menu, *this, view);
  menu->popup(view.canvas()->mapToGlobal(position));
}

void PlotPanel::toggleCursors() {
  currentPlot().cursors().show(!currentPlot().cursors().times().any());
}

void PlotPanel::shareMemory() {
  std::size_t count = 0;
  for (const PlotView* view : tabs_.plots()) count += view->curves().curves().size();
  const std::size_t budget = memory_ / std::max<std::size_t>(count, 1);
  for (PlotView* view : tabs_.plots()) {
    for (const auto& curve : view->curves().curves()) curve->setBudget(budget);
  }
}

void PlotPanel::updateHead() {
  if (plotCount() == 0) return;
  updateStandstills();
  std::size_t used = 0;
  bool is_thinned = false;
  for (PlotView* view : tabs_.plots()) {
    for (const auto& curve : view->curves().curves()) {
      used += curve->bytes();
      is_thinned = is_thinned || curve->isThinned();
    }
  }
  head_->setMemory(used, memory_, is_thinned);
  auto figures = currentPlot().curves().figures(currentPlot().now());
  for (SourceFigures& each : figures) {
    if (losses_) each.losses = losses_(each.path).since(each.losses_before);
  }
  head_->setFigures(figures);
  head_->setWindow(currentPlot().timeWindow().length());
  head_->setCursors(currentPlot().cursors().times().any());
  head_->setSweeping(currentPlot().timeWindow().motion() == TimeWindow::Motion::kSweep);
  head_->setWay(currentPlot().gestures().hasFormerView(), currentPlot().gestures().hasLaterView());
}

PlotView& PlotPanel::addPlot() {
  auto* page = new PlotPage(pages_);
  connect(page, &PlotPage::currentChanged, this, &PlotPanel::updateHead);
  connect(page, &PlotPage::closeRequested, this, [this](PlotView* view) { closePlot(*view); });
  pages_->addWidget(page);
  const int index = head_->tabs().addTab({});
  PlotView& view = page->current();
  prepare(view);
  tabs_.update(tabs_.pageOf(view));
  showPage(index);
  return view;
}

PlotView& PlotPanel::splitPlot() {
  PlotView& view = tabs_.currentPage().split();
  prepare(view);
  tabs_.update(tabs_.pageOf(view));
  updateHead();
  return view;
}

void PlotPanel::closePlot(int index) { closePlot(plot(index)); }

void PlotPanel::closePlot(PlotView& view) {
  QStringList paths;
  for (const auto& curve : view.curves().curves()) paths << curve->path();
  for (const QString& path : paths) removeFrom(view, path);
  PlotPage& page = tabs_.pageOf(view);
  if (page.views().size() > 1) {
    page.close(view);
    return tabs_.update(page);
  }
  if (pages_->count() == 1) return;
  head_->tabs().removeTab(pages_->indexOf(&page));
  pages_->removeWidget(&page);
  page.deleteLater();
  tabs_.update();
  showPage(head_->tabs().currentIndex());
}

void PlotPanel::closePage(int index) {
  const std::vector<PlotView*> views = tabs_.page(index).views();
  for (PlotView* view : views) closePlot(*view);
}

void PlotPanel::showTabMenu(const QPoint& position) {
  const int index = head_->tabs().tabAt(position);
  if (index < 0) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const bool are_several = tabs_.page(index).views().size() > 1;
  menu->addAction(Words::tr("Rename…"), this, [this, index] {
    showPage(index);
    askForName();
  });
  menu->addAction(are_several ? Words::tr("Close plots") : Words::tr("Close plot"), this,
                  [this, index] { closePage(index); });
  menu->popup(head_->tabs().mapToGlobal(position));
}

void PlotPanel::showPage(int index) {
  head_->tabs().setCurrentIndex(index);
  pages_->setCurrentIndex(index);
  updateHead();
}

void PlotPanel::showPlot(int index) {
  PlotView& view = plot(index);
  PlotPage& page = tabs_.pageOf(view);
  page.setCurrent(view);
  showPage(pages_->indexOf(&page));
}

void PlotPanel::askForName() {
  PlotView& view = currentPlot();
  auto* dialog = new QInputDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(Words::tr("Rename this plot"));
  dialog->setLabelText(Words::tr("Name; leave it empty for the default name"));
  dialog->setTextValue(tabs_.name(view));
  connect(dialog, &QInputDialog::textValueSelected, &view,
          [this, &view](const QString& name) { tabs_.setName(view, name); });
  dialog->open();
}

PlotView& PlotPanel::plot(int index) const {
  return *tabs_.plots().at(static_cast<std::size_t>(index));
}

bool PlotPanel::isBelow(int index) const {
  const PlotView& view = plot(index);
  return tabs_.pageOf(view).views().front() != &view;
}

int PlotPanel::plotCount() const { return static_cast<int>(tabs_.plots().size()); }

PlotView& PlotPanel::currentPlot() const { return tabs_.currentPage().current(); }

int PlotPanel::currentIndex() const {
  const std::vector<PlotView*> all = tabs_.plots();
  return static_cast<int>(std::find(all.begin(), all.end(), &currentPlot()) - all.begin());
}

// Moves a curve with its samples to `to`. If that plot already has the path, only removes the
// curve.
void PlotPanel::move(const QString& path, quint64 from, PlotView& to) {
  for (PlotView* view : tabs_.plots()) {
    if (view->id() != from || view == &to) continue;
    std::unique_ptr<Curve> curve = view->takeCurve(path);
    if (curve == nullptr) return;
    if (to.curve(path) == nullptr) to.adoptCurve(std::move(curve));
    shareMemory();
    tabs_.update(tabs_.pageOf(*view));
    tabs_.update(tabs_.pageOf(to));
    tabs_.pageOf(to).setCurrent(to);
    updateHead();
  }
}

}  // namespace tendon::gui
