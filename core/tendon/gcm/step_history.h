#pragma once

#include <tendon/gcm/gcm_messages.h>
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

/// Returns the text of a step: "connect desk/teleoperation/Robot robot/arm/Control", "start
/// robot/arm", "start robot".
[[nodiscard]] std::string ToString(const message::HistoryEntry& step);

/// The program that undid a step, and the time of the undo.
struct UndoMark {
  std::string who;        ///< the program that requested the undo; empty if unknown
  std::int64_t when = 0;  ///< ns since 1970
};

/// The steps of users. They are kept in a file with one JSON object per line, so that they can also
/// be undone after a restart of the GCM. Keeps the newest kMaxSteps, or fewer if these exceed
/// kMaxBytes. Rewrites the file when it is larger than twice kMaxBytes. Ignores the last line if a
/// crash has cut it off. Ignores other invalid lines, with a warning.
///
/// A new step is in memory at once. A separate thread writes it to the file, so a slow disk delays
/// only callers that wait for `done`. A crash can lose only steps whose `done` was not called yet.
/// If a step cannot be written, the history logs the error and keeps the step in memory until the
/// process ends.
///
/// Thread safety: all functions except Close() may be called at any time, in any thread.
class StepHistory {
 public:
  static constexpr std::size_t kMaxSteps = 1000;
  static constexpr std::size_t kMaxBytes = std::size_t{4} << 20U;
  /// Called once when the step is on the disk, or when writing has failed. The calls are made in
  /// the order of the steps, in the history's thread or in Close().
  using Done = std::function<void()>;

  /// Reads the file, if it exists. If the file cannot be written later, the history's thread logs
  /// this.
  explicit StepHistory(std::filesystem::path file);
  StepHistory(const StepHistory&) = delete;
  StepHistory& operator=(const StepHistory&) = delete;
  /// Calls Close().
  ~StepHistory();

  /// Adds a step and returns its number.
  std::uint64_t Record(message::HistoryEntry step, Done done);
  void MarkUndone(std::uint64_t id, Done done, const UndoMark& by = {});
  void MarkPassedOver(std::uint64_t id, Done done);
  /// Waits until all steps are on the disk. No steps may be added afterwards.
  void Close();

  /// Oldest first.
  [[nodiscard]] message::History steps() const;
  /// Returns the program that undid a step, and the time of the undo; `who` is empty if the program
  /// is unknown.
  [[nodiscard]] UndoMark undo_of(std::uint64_t id) const;
  /// Returns the newest step that was neither undone nor skipped.
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
  // Used only in the writing thread.
  bool is_torn_ = false;  // true if the file may end in the middle of a line
  std::size_t file_bytes_ = 0;

  mutable std::mutex mutex_;  // guards the members below
  std::vector<message::HistoryEntry> steps_;
  std::deque<std::size_t> bytes_;  // size of each step's line
  std::size_t all_bytes_ = 0;
  std::map<std::uint64_t, UndoMark> undos_;  // by number of the step
  std::uint64_t last_id_ = 0;
  std::vector<Line> unwritten_;
  Worker writer_{"gcm-history"};
};

}  // namespace tendon
