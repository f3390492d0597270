#pragma once

#include <tendon/base/name.h>
#include <tendon/process/life/life_messages.h>

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
    kSteer,
    kCall,
    kLogLevel,
    kApply
  };
  enum class Outcome { kRunning, kDone, kRefused };

  Verb verb = Verb::kConnect;
  InterfaceName required;  ///< of connect, disconnect, replace; of undo once known
  InterfaceName provided;
  std::string process;               ///< of forget and of a log level
  LifeVerb life = LifeVerb::kStart;  ///< of steer
  std::string component;             ///< of steer: its path; of undo once known
  QString command;                   ///< of call: its path
  QString argument;  ///< of call: JSON; of a log level: its name; of apply: the system it leads to
  QString file;      ///< of apply: the system file; empty if it was never saved

  Outcome outcome = Outcome::kRunning;
  QString refusal;        ///< the reason of a refusal
  std::int64_t when = 0;  ///< the time of the request, ns since 1970
  double seconds = 0;     ///< from the request to the answer
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
  /// The shell command that does the same, or empty.
  [[nodiscard]] QString command(int row) const;
  /// True for the action that Undo takes back: the newest not undone, with no plan after it.
  [[nodiscard]] bool canUndo(int row) const;

  /// A repeated call updates the count of its row instead of adding a row.
  Id begin(Action action);
  /// An undo also learns here which interfaces it changed.
  void finish(Id id, double seconds, const QString& refusal);
  /// Marks the newest action that matches `step` and is not undone yet.
  void markUndone(Id undo, const Action& step);

 Q_SIGNALS:
  void finished(const tendon::gui::Action& action);
  /// An action was taken back.
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
