#pragma once

#include <QHash>
#include <QList>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <mutex>

class QWidget;

namespace tendon::gui {

class ViewCover;

/// What a view was doing when it threw.
enum class ViewWork {
  kDrawing,   ///< a cover replaces the view until the user retries
  kHandling,  ///< an event, a timer, or a change of the system: the view stays visible
};

/// An exception that a view has thrown, and its count.
struct ViewFault {
  QString view;
  QString what;  ///< the message of the exception
  std::uint64_t count = 0;
  std::int64_t first = 0;   ///< ns since 1970
  std::int64_t latest = 0;  ///< ns since 1970
  bool is_covered = false;  ///< the view is not drawn until the user retries

  bool operator==(const ViewFault&) const = default;
};

/// Catches the exceptions of views, so that none of them ends the program.
///
/// GuardedApplication catches exceptions from event handlers. Three kinds of code must be called
/// through run(): slots that share a signal of the system with others, so that all of them are
/// called; drawing with a painter that Qt owns, because Qt does not end the painter after an
/// exception; and threads. Faults are counted by view and message; changed() is emitted at once for
/// a new fault, and at most once a second for repeated faults.
///
/// GUI thread, except recordException() and run(), which any thread may call. Call instance() once
/// before, so that run() need not create the ExceptionGuard when memory may be exhausted.
class ExceptionGuard : public QObject {
  Q_OBJECT

 public:
  static ExceptionGuard& instance();

  /// Reports exceptions of this object, or of a child without its own name, under this name; if it
  /// is empty, under the accessible name. A cover hides a whole widget, so a splitter must not be a
  /// view. Dialogs are views without a call.
  static void setName(QObject& view, const QString& name);

  /// Calls `part`; returns false if it threw. `where` may be null.
  template <typename Part>
  static bool run(QObject* where, ViewWork work, Part&& part) noexcept {
    try {
      part();
      return true;
    } catch (...) {
      instance().recordException(where, work);
      return false;
    }
  }
  /// The same for code in a thread, without a view.
  template <typename Part>
  static bool run(const char* thread_name, Part&& part) noexcept {
    try {
      part();
      return true;
    } catch (...) {
      instance().recordThreadException(thread_name);
      return false;
    }
  }

  /// Records the exception being handled. Never throws; without memory, only counts it.
  void recordException(QObject* where, ViewWork work) noexcept;
  void recordThreadException(const char* thread_name) noexcept;

  /// True if the widget is below a cover and must not be drawn.
  [[nodiscard]] bool isCovered(const QObject* widget) const;
  /// Removes the cover and redraws the view.
  void showAgain(QWidget& view);
  /// Reports the faults that were only counted because of missing memory. The window's regular
  /// timer calls it, because starting a timer would also need memory.
  void reportCountedFaults();
  /// The faults of covered views, and others for ten minutes after their last occurrence.
  [[nodiscard]] QList<ViewFault> faults() const;

 Q_SIGNALS:
  void changed();
  /// A new fault, or one with ten times the count of its last report.
  void faultReported(const tendon::gui::ViewFault& fault);

 private:
  struct Entry {
    ViewFault fault;
    QPointer<QWidget> view;
    std::uint64_t report_at = 1;  // the count
  };

  explicit ExceptionGuard(QObject* parent);

  void note(const QString& name, QWidget* view, const QString& what, std::uint64_t times = 1);
  void cover(QWidget& view);
  void announce();
  void dropOld();
  void count() noexcept;

  QList<Entry> entries_;
  QHash<const QObject*, QPointer<ViewCover>> covers_;  // by view; null until it is built
  QTimer pause_;                                       // pause between two changed() signals
  bool has_news_ = false;
  std::mutex mutex_;
  std::uint64_t unreported_ = 0;  // faults not noted for lack of memory; guarded by mutex_
};

/// Wraps a slot: if it throws, the other receivers of the signal are still called.
template <typename Receiver, typename... Args>
[[nodiscard]] auto Guarded(Receiver* receiver, void (Receiver::*slot)(Args...)) {
  return [receiver, slot](Args... args) {
    ExceptionGuard::run(receiver, ViewWork::kHandling, [&] { (receiver->*slot)(args...); });
  };
}

/// The message of the current exception; call it in a handler only.
[[nodiscard]] QString CurrentExceptionText();

}  // namespace tendon::gui
