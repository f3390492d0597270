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

/// The activity of a view when it threw an exception.
enum class ViewWork {
  kDrawing,   ///< painting: a cover replaces the view until the user retries
  kHandling,  ///< handling an event, a timer or a change of the system: the view stays visible
};

/// An exception that a view has thrown, with the number of times it was thrown.
struct ViewFault {
  QString view;
  QString what;  ///< the message of the exception
  std::uint64_t count = 0;
  std::int64_t first = 0;   ///< ns since 1970
  std::int64_t latest = 0;  ///< ns since 1970
  bool is_covered = false;  ///< the view is not painted until the user retries

  bool operator==(const ViewFault&) const = default;
};

/// Catches the exceptions of views, so that no exception ends the program.
///
/// GuardedApplication catches exceptions from event handlers. Call the following code through
/// run():
/// - slots that share a signal of the system with other slots, so that all slots are called;
/// - code that draws with a painter of Qt, because Qt does not end the painter after an exception;
/// - the main functions of threads.
///
/// Faults are counted by view and message. changed() is emitted at once for a new fault, and at
/// most once a second for repeated faults.
///
/// Use it in the GUI thread only, except recordException() and run(), which any thread may call.
/// Call instance() once at the start of the program: otherwise run() would have to create the
/// ExceptionGuard when memory may be exhausted.
class ExceptionGuard : public QObject {
  Q_OBJECT

 public:
  static ExceptionGuard& instance();

  /// Sets the name under which exceptions of this object are reported. Children without a name of
  /// their own use the same name. If `name` is empty, the accessible name of the object is used. A
  /// cover hides the whole widget, so do not name a splitter. A dialog needs no name.
  static void setName(QObject& view, const QString& name);

  /// Calls `part`; returns false if `part` threw an exception. `where` may be null.
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
  /// Calls `part` as above, for code that runs in a thread and belongs to no view.
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

  /// Records the exception that is being handled. Never throws: if memory is exhausted, only counts
  /// the exception.
  void recordException(QObject* where, ViewWork work) noexcept;
  void recordThreadException(const char* thread_name) noexcept;

  /// Returns true if the widget is below a cover and must not be painted.
  [[nodiscard]] bool isCovered(const QObject* widget) const;
  /// Removes the cover and redraws the view.
  void showAgain(QWidget& view);
  /// Reports the faults that were only counted because memory was exhausted. A timer of the window
  /// calls this function regularly: starting a new timer for a report would need memory.
  void reportCountedFaults();
  /// Returns the faults of covered views, and all faults of the last ten minutes.
  [[nodiscard]] QList<ViewFault> faults() const;

 Q_SIGNALS:
  void changed();
  /// Emitted for a new fault, and again when the count of a fault is ten times its count at the
  /// last report.
  void faultReported(const tendon::gui::ViewFault& fault);

 private:
  struct Entry {
    ViewFault fault;
    QPointer<QWidget> view;
    std::uint64_t report_at = 1;  // the count at which the fault is reported next
  };

  explicit ExceptionGuard(QObject* parent);

  void note(const QString& name, QWidget* view, const QString& what, std::uint64_t times = 1);
  void cover(QWidget& view);
  void announce();
  void dropOld();
  void count() noexcept;

  QList<Entry> entries_;
  QHash<const QObject*, QPointer<ViewCover>> covers_;  // by view; null until the cover is built
  QTimer pause_;                                       // pause between two changed() signals
  bool has_news_ = false;
  std::mutex mutex_;
  std::uint64_t unreported_ = 0;  // only counted, because memory was exhausted; guarded by mutex_
};

/// Wraps a slot so that the other receivers of the signal are called even if this slot throws.
template <typename Receiver, typename... Args>
[[nodiscard]] auto Guarded(Receiver* receiver, void (Receiver::*slot)(Args...)) {
  return [receiver, slot](Args... args) {
    ExceptionGuard::run(receiver, ViewWork::kHandling, [&] { (receiver->*slot)(args...); });
  };
}

/// Returns the message of the current exception; call it only in a handler.
[[nodiscard]] QString CurrentExceptionText();

}  // namespace tendon::gui
