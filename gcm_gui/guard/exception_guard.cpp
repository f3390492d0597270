#include <gcm_gui/guard/exception_guard.h>

#include <gcm_gui/guard/view_cover.h>
#include <gcm_gui/language/words.h>

#include <QApplication>
#include <QMainWindow>
#include <QThread>
#include <QWidget>
#include <algorithm>
#include <chrono>
#include <exception>
#include <new>

namespace tendon::gui {
namespace {

constexpr auto kName = "tendonView";
constexpr std::chrono::seconds kPause{1};
// The time for which a fault of a view without a cover is listed.
constexpr std::chrono::minutes kKept{10};
constexpr qsizetype kMaxFaults = 50;

std::int64_t Now() {
  return std::chrono::nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// Returns the nearest object, from `where` upwards, that has a name or is a dialog; null if there
/// is none.
QObject* ViewAt(QObject* where) {
  for (; where != nullptr; where = where->parent()) {
    if (where->property(kName).isValid()) return where;
    const auto* widget = qobject_cast<QWidget*>(where);
    if (widget == nullptr || !widget->isWindow()) continue;
    return qobject_cast<QMainWindow*>(where) == nullptr ? where : nullptr;
  }
  return nullptr;
}

/// Returns the given name of an object; otherwise its accessible name, the title of its window, or
/// its class.
QString NameOf(const QObject& part) {
  const QString given = part.property(kName).toString();
  if (!given.isEmpty()) return given;
  for (const QObject* each = &part; each != nullptr; each = each->parent()) {
    const auto* widget = qobject_cast<const QWidget*>(each);
    if (widget == nullptr) continue;
    if (!widget->accessibleName().isEmpty()) return widget->accessibleName();
    if (!widget->isWindow()) continue;
    if (qobject_cast<const QMainWindow*>(widget) == nullptr && !widget->windowTitle().isEmpty()) {
      return widget->windowTitle();
    }
    break;
  }
  return QString::fromLatin1(part.metaObject()->className()).section(QStringLiteral("::"), -1);
}

}  // namespace

QString CurrentExceptionText() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return Words::tr("there is not enough memory");
  } catch (const std::exception& error) {
    return QString::fromUtf8(error.what());
  } catch (...) {
    return Words::tr("an exception without a message");
  }
}

ExceptionGuard::ExceptionGuard(QObject* parent) : QObject(parent) {
  pause_.setSingleShot(true);
  connect(&pause_, &QTimer::timeout, this, &ExceptionGuard::announce);
}

ExceptionGuard& ExceptionGuard::instance() {
  static QPointer<ExceptionGuard> guard;
  if (guard == nullptr) guard = new ExceptionGuard(qApp);
  return *guard;
}

void ExceptionGuard::setName(QObject& view, const QString& name) { view.setProperty(kName, name); }

void ExceptionGuard::recordException(QObject* where, ViewWork work) noexcept {
  try {
    const QString what = CurrentExceptionText();
    if (QThread::currentThread() != thread()) {
      const QString name = where == nullptr ? Words::tr("Window") : NameOf(*where);
      QMetaObject::invokeMethod(
          this, [this, name, what] { note(name, nullptr, what); }, Qt::QueuedConnection);
      return;
    }
    QObject* const view = ViewAt(where);
    QObject* const part = view != nullptr ? view : where;
    auto* widget = qobject_cast<QWidget*>(part);
    if (qobject_cast<QMainWindow*>(part) != nullptr) widget = nullptr;
    if (work == ViewWork::kDrawing && widget != nullptr) cover(*widget);
    note(part == nullptr ? Words::tr("Window") : NameOf(*part), widget, what);
  } catch (...) {
    count();
  }
}

void ExceptionGuard::recordThreadException(const char* thread_name) noexcept {
  try {
    const QString what = CurrentExceptionText();
    QMetaObject::invokeMethod(
        this, [this, thread_name, what] { note(Words::tr(thread_name), nullptr, what); },
        Qt::QueuedConnection);
  } catch (...) {
    count();
  }
}

void ExceptionGuard::count() noexcept {
  const std::lock_guard lock(mutex_);
  ++unreported_;
}

void ExceptionGuard::reportCountedFaults() {
  std::unique_lock lock(mutex_);
  const std::uint64_t unreported = unreported_;
  lock.unlock();
  if (unreported == 0) return;
  note(Words::tr("Window"), nullptr, Words::tr("there is not enough memory"), unreported);
  lock.lock();
  unreported_ -= unreported;
}

void ExceptionGuard::note(const QString& name, QWidget* view, const QString& what,
                          std::uint64_t times) {
  const auto is_same = [&](const Entry& entry) {
    return entry.fault.view == name && entry.fault.what == what;
  };
  auto entry = std::find_if(entries_.begin(), entries_.end(), is_same);
  if (entry == entries_.end()) {
    dropOld();
    while (entries_.size() >= kMaxFaults) entries_.removeFirst();
    entries_.append({.fault = {.view = name, .what = what, .first = Now()}, .view = view});
    entry = entries_.end() - 1;
  }
  ViewFault& fault = entry->fault;
  fault.count += times;
  fault.latest = Now();
  fault.is_covered = view != nullptr && covers_.contains(view);
  entry->view = view;
  has_news_ = true;
  // changed() is not emitted immediately, because a receiver may be the view that has just thrown
  // the exception.
  if (!pause_.isActive()) pause_.start(0);
}

void ExceptionGuard::cover(QWidget& view) {
  if (covers_.contains(&view)) return;
  covers_.insert(&view, nullptr);
  connect(&view, &QObject::destroyed, this, [this](const QObject* gone) { covers_.remove(gone); });
  // The cover is not created immediately, because the painter of the view is still active.
  QMetaObject::invokeMethod(
      &view,
      [this, &view] {
        if (!covers_.contains(&view) || covers_.value(&view) != nullptr) return;
        ViewCover* built = nullptr;
        try {
          built = new ViewCover(view);
        } catch (...) {
          // The view is painted again later, when there may be enough memory.
          covers_.remove(&view);
          count();
          return;
        }
        covers_.insert(&view, built);
        connect(built, &ViewCover::shownAgainRequested, this, [this, &view] { showAgain(view); });
      },
      Qt::QueuedConnection);
}

bool ExceptionGuard::isCovered(const QObject* widget) const {
  if (covers_.isEmpty()) return false;
  for (; widget != nullptr; widget = widget->parent()) {
    if (qobject_cast<const ViewCover*>(widget) != nullptr) return false;
    if (covers_.contains(widget)) return true;
    if (widget->isWidgetType() && static_cast<const QWidget*>(widget)->isWindow()) return false;
  }
  return false;
}

void ExceptionGuard::showAgain(QWidget& view) {
  const QPointer<ViewCover> cover = covers_.take(&view);
  entries_.removeIf([&](const Entry& entry) { return entry.view == &view; });
  if (cover != nullptr) cover->leave();
  view.update();
  for (QWidget* part : view.findChildren<QWidget*>()) part->update();
  Q_EMIT changed();
}

QList<ViewFault> ExceptionGuard::faults() const {
  QList<ViewFault> all;
  const std::int64_t oldest = Now() - std::chrono::nanoseconds(kKept).count();
  for (const Entry& entry : entries_) {
    ViewFault fault = entry.fault;
    if (entry.view == nullptr) fault.is_covered = false;  // the dialog was closed
    if (fault.is_covered || fault.latest > oldest) all.append(fault);
  }
  return all;
}

void ExceptionGuard::dropOld() {
  const std::int64_t oldest = Now() - std::chrono::nanoseconds(kKept).count();
  entries_.removeIf([&](const Entry& entry) {
    return (entry.view == nullptr || !entry.fault.is_covered) && entry.fault.latest <= oldest;
  });
}

void ExceptionGuard::announce() {
  reportCountedFaults();
  if (!has_news_) return;
  has_news_ = false;
  pause_.start(kPause);
  constexpr std::uint64_t kTimesMore = 10;
  QList<ViewFault> due;
  for (Entry& entry : entries_) {
    if (entry.fault.count < entry.report_at) continue;
    entry.report_at = entry.fault.count * kTimesMore;
    due.append(entry.fault);
  }
  for (const ViewFault& fault : due) Q_EMIT faultReported(fault);
  Q_EMIT changed();
}

}  // namespace tendon::gui
