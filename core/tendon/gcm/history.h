#pragma once

#include <tendon/gcm/messages.h>
#include <tendon/process/worker.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace tendon {

/// "connect desk/teleoperation/Robot robot/arm/Control", "start robot/arm", "start robot": the step
/// for people.
[[nodiscard]] std::string ToString(const message::HistoryEntry& step);

/// Who has taken a step back, and when.
struct UndoMark {
  std::string who;        ///< the program that asked; empty where that is not known
  std::int64_t when = 0;  ///< ns since 1970
};

/// The steps that were made, kept in a file of one JSON object a line, so that they can be undone
/// after a restart too. The newest kMaxSteps are kept, or as many as fit into kMaxBytes of the
/// file; that is written anew when it has grown to twice as much. A last line that a crash cut
/// short is left out; another one that does not read is left out with a warning.
///
/// A step is known at once. A thread of its own waits for the disk, so that a slow one delays
/// nobody but who waits for `done`: a kill loses at most the steps whose `done` was not called yet.
/// When the disk refuses, that is logged, and the step is known until the end of the process;
/// whether it would is tried at the start.
///
/// Thread safety: all functions but Close() at any time.
class History {
 public:
  static constexpr std::size_t kMaxSteps = 1000;
  static constexpr std::size_t kMaxBytes = std::size_t{4} << 20U;
  /// Called once, in the order of the steps, by the history's thread or by Close().
  using Done = std::function<void()>;

  /// Reads what the file holds; a missing one is empty. One that cannot be written is said in the
  /// log, by the history's thread.
  explicit History(std::filesystem::path file);
  History(const History&) = delete;
  History& operator=(const History&) = delete;
  /// Close().
  ~History();

  /// Adds a step; returns its number.
  std::uint64_t Record(message::HistoryEntry step, Done done);
  void MarkUndone(std::uint64_t id, Done done, const UndoMark& by = {});
  void MarkPassedOver(std::uint64_t id, Done done);
  /// Waits until the disk has everything. Record() and the others must not be called any more.
  void Close();

  /// Oldest first.
  [[nodiscard]] message::History steps() const;
  /// Of a step that was undone; of nobody where that is not known.
  [[nodiscard]] UndoMark undo_of(std::uint64_t id) const;
  /// The newest step that was neither undone nor passed over.
  [[nodiscard]] std::optional<message::HistoryEntry> last() const;

 private:
  struct Line {
    std::string text;
    Done done;
  };

  void Mark(std::uint64_t id, const char* what, Done done, const UndoMark& by = {});
  void Load();
  void Probe() const;
  void Keep(message::HistoryEntry step, std::size_t bytes);
  [[nodiscard]] std::string Text() const;
  bool Replace(const std::string& text);
  bool Append(const std::vector<Line>& lines);
  void Write();

  const std::filesystem::path file_;
  // Of the thread that writes.
  bool is_torn_ = false;  // the file may end in the middle of a line
  std::size_t file_bytes_ = 0;

  mutable std::mutex mutex_;  // of what follows
  std::vector<message::HistoryEntry> steps_;
  std::deque<std::size_t> bytes_;  // of the line of each step
  std::size_t all_bytes_ = 0;
  std::map<std::uint64_t, UndoMark> undos_;  // of steps that are known, by their numbers
  std::uint64_t last_id_ = 0;
  std::vector<Line> unwritten_;
  Worker writer_{"gcm-history"};
};

}  // namespace tendon
