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
  kDrawing,   ///< it cannot be shown: a cover stands over it until the user asks for it again
  kHandling,  ///< an event, a timer, or news of the system: the view stays as it is
};

/// An exception that came out of a view, and how often it did.
struct ViewFault {
  QString view;
  QString what;  ///< the exception's own words
  std::uint64_t count = 0;
  std::int64_t first = 0;   ///< ns since 1970
  std::int64_t latest = 0;  ///< likewise
  bool is_covered = false;  ///< the view is not drawn until the user asks for it

  bool operator==(const ViewFault&) const = default;
};

/// Keeps exceptions inside the view they come out of, so that none ends the window.
///
/// FencedApplication catches what leaves an event handler. Three kinds of code need a fence of
/// their own, by run(): slots that hear the system together with others, which must all hear it;
/// what is drawn inside a painter that Qt owns, for Qt's own frames leave it open when an exception
/// passes them; and threads. Faults are counted by view and words; changed() comes at once for a
/// new one and once a second at most for repeated ones.
///
/// GUI thread, except hear() and run(), which any thread may call once instance() has been called:
/// run() must not be what builds it, perhaps without memory.
class Fence : public QObject {
  Q_OBJECT

 public:
  static Fence& instance();

  /// What throws at this object, or at a child of it that has no name, is told under this name; an
  /// empty one stands for what a screen reader calls it. A widget is covered as a whole, so no
  /// splitter may be a view. Dialogs are views by themselves.
  static void setName(QObject& view, const QString& name);

  /// Calls `part`; false where it has thrown. `where` may be null.
  template <typename Part>
  static bool run(QObject* where, ViewWork work, Part&& part) noexcept {
    try {
      part();
      return true;
    } catch (...) {
      instance().hear(where, work);
      return false;
    }
  }
  /// The same for a thread, which has no view.
  template <typename Part>
  static bool run(const char* thread_name, Part&& part) noexcept {
    try {
      part();
      return true;
    } catch (...) {
      instance().hearThread(thread_name);
      return false;
    }
  }

  /// The exception that is being handled. Does not throw: without memory only its number is kept.
  void hear(QObject* where, ViewWork work) noexcept;
  void hearThread(const char* thread_name) noexcept;

  /// Whether the widget lies below a cover, so that it must not be drawn.
  [[nodiscard]] bool isCovered(const QObject* widget) const;
  /// Takes the cover away and draws the view anew.
  void showAgain(QWidget& view);
  /// Tells of those that could only be counted, for want of memory: no timer could be started for
  /// them, so the window's tick calls it.
  void noteUnnoted();
  /// Those of covered views, and others until ten minutes have passed without another one.
  [[nodiscard]] QList<ViewFault> faults() const;

 Q_SIGNALS:
  void changed();
  /// A new one, or one that has been counted ten times as often as when it was told the last time.
  void told(const tendon::gui::ViewFault& fault);

 private:
  struct Entry {
    ViewFault fault;
    QPointer<QWidget> view;
    std::uint64_t tell_at = 1;  // the count
  };

  explicit Fence(QObject* parent);

  void note(const QString& name, QWidget* view, const QString& what, std::uint64_t times = 1);
  void cover(QWidget& view);
  void announce();
  void dropOld();
  void count() noexcept;

  QList<Entry> entries_;
  QHash<const QObject*, QPointer<ViewCover>> covers_;  // of views; null until it is built
  QTimer pause_;                                       // between two announcements
  bool has_news_ = false;
  std::mutex mutex_;
  std::uint64_t unnoted_ = 0;  // for want of memory; guarded by mutex_
};

/// A slot with a fence: what it throws keeps no other receiver of the signal from hearing it.
template <typename Receiver, typename... Args>
[[nodiscard]] auto Fenced(Receiver* receiver, void (Receiver::*slot)(Args...)) {
  return [receiver, slot](Args... args) {
    Fence::run(receiver, ViewWork::kHandling, [&] { (receiver->*slot)(args...); });
  };
}

/// What is thrown, in its own words; in a handler of it.
[[nodiscard]] QString WordsOfException();

}  // namespace tendon::gui
