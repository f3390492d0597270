#pragma once

#include <tendon/base/name.h>
#include <tendon/process/life/messages.h>

#include <QAbstractTableModel>
#include <QString>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tendon::gui {

/// One thing the user did to the system, and what came of it.
struct Action {
  enum class Verb {
    kConnect,
    kDisconnect,
    kReplace,
    kUndo,
    kForget,
    kSteer,
    kCall,
    kLogLevel,
    kApply
  };
  enum class Outcome { kRunning, kDone, kRefused };

  Verb verb = Verb::kConnect;
  InterfaceName required;  ///< of connect, disconnect and replace; of undo once it is known
  InterfaceName provided;
  std::string process;               ///< of forget and of a log level
  LifeVerb life = LifeVerb::kStart;  ///< of steer
  std::string component;             ///< of steer: its path; of undo once it is known
  QString command;                   ///< of call: its path
  QString argument;  ///< of call: JSON; of a log level: its name; of apply: what it leads to
  QString file;      ///< of apply: the system file, or empty where it is none that was saved

  Outcome outcome = Outcome::kRunning;
  QString refusal;        ///< why it was refused
  std::int64_t when = 0;  ///< it was asked for, ns since 1970
  double seconds = 0;     ///< until the answer
  bool undone = false;
  int times = 1;  ///< of calls with the same argument, one after another
};

/// What was done through this window, newest first.
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
  /// The line that does the same in a terminal, or empty.
  [[nodiscard]] QString command(int row) const;
  /// Whether Undo would take back this one: the newest that stands, behind which no plan came.
  [[nodiscard]] bool canUndo(int row) const;

  /// The same call once more stays in its row, and is counted.
  Id begin(Action action);
  /// The ends are those an undo turned out to have changed.
  void finish(Id id, double seconds, const QString& refusal);
  /// Marks the newest action that stands and did the same as `step`.
  void markUndone(Id undo, const Action& step);

 Q_SIGNALS:
  void finished(const tendon::gui::Action& action);
  /// One of them was taken back.
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
