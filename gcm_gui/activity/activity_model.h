#pragma once

#include <tendon/base/name.h>
#include <tendon/process/lifecycle/lifecycle_messages.h>

#include <QAbstractTableModel>
#include <QString>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tendon::gui {

/// One action of the user on the system, and its outcome.
struct Action {
  enum class Verb {
    kConnect,
    kDisconnect,
    kReplace,
    kUndo,
    kForget,
    kLifecycle,
    kCall,
    kLogLevel,
    kApply,
    kRecord,
    kSaveLast
  };
  enum class Outcome { kRunning, kDone, kRefused };

  Verb verb = Verb::kConnect;
  InterfaceName required;  ///< for connect, disconnect and replace; for undo if known
  InterfaceName provided;
  std::string process;                                   ///< for forget and a log level
  LifecycleVerb lifecycle_verb = LifecycleVerb::kStart;  ///< for lifecycle
  std::string component;  ///< the path; for lifecycle, and for undo if known
  QString command;        ///< the path; for call
  /// For call: JSON. For a log level: the name of the level. For apply: the name of the target
  /// system. For record: the paths, as in a shell; if a history was saved, its time comes before
  /// them.
  QString argument;
  /// For apply: the system file, empty if not saved; for a recording or a saved history: its file.
  QString file;

  Outcome outcome = Outcome::kRunning;
  QString refusal;        ///< the reason of a refusal
  std::int64_t when = 0;  ///< the time of the request, ns since 1970
  double seconds = 0;     ///< from the request to the reply
  bool undone = false;
  int times = 1;  ///< number of successive calls with the same argument
};

/// The actions taken through this window, newest first.
class ActivityModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kWhat, kLinks, kColumnCount };
  using Id = std::uint64_t;

  using QAbstractTableModel::QAbstractTableModel;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

  [[nodiscard]] const Action& action(int row) const;
  /// Returns the shell command that does the same as the action; empty if there is none.
  [[nodiscard]] QString command(int row) const;
  /// Returns true for the action that the command Undo would undo: the newest action that is not
  /// yet undone. Returns false if a plan was executed after this action.
  [[nodiscard]] bool canUndo(int row) const;

  /// Adds a row for an action that has begun. For a repeated call, increments the count of the
  /// call's row instead.
  Id begin(Action action);
  /// Stores the outcome of an action; `refusal` is empty if the action succeeded.
  void finish(Id id, double seconds, const QString& refusal);
  /// Marks the newest action that matches `step` and is not undone yet as undone. Copies the
  /// interfaces and the component of `step` to the action `undo`.
  void markUndone(Id undo, const Action& step);

 Q_SIGNALS:
  void finished(const tendon::gui::Action& action);
  /// An action was undone.
  void undone(const tendon::gui::Action& action);

 private:
  struct Entry {
    Id id;
    Action action;
  };
  [[nodiscard]] int rowOf(Id id) const;
  [[nodiscard]] bool isOnceMore(const Action& action) const;
  [[nodiscard]] const Action* lastStep() const;
  [[nodiscard]] QString object(const Action& action) const;
  [[nodiscard]] QString outcome(const Action& action) const;
  void changed(int row);
  void changedUndo();

  std::vector<Entry> entries_;  // oldest first
  Id last_id_ = 0;
};

}  // namespace tendon::gui
