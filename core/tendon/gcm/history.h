#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/messages.h>

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace tendon {

/// The steps that were made, kept in a file of one JSON object a line, so that they can be undone
/// after a restart too. The newest kMaxSteps are kept. A last line that a crash cut short is left
/// out; another one that does not read is left out with a warning.
///
/// Thread safety: reading at any time; Record() and MarkUndone() in one thread, for they wait for
/// the disk. When that fails the step is still known until the end of the process.
class History {
 public:
  static constexpr std::size_t kMaxSteps = 1000;

  /// Reads what the file holds; a missing one is empty.
  explicit History(std::filesystem::path file);

  /// Adds a step and numbers it. The error is the disk's.
  Result<void> Record(message::HistoryEntry& step);
  Result<void> MarkUndone(std::uint64_t id);

  /// Oldest first.
  [[nodiscard]] message::History steps() const;
  /// The newest step that was not undone.
  [[nodiscard]] std::optional<message::HistoryEntry> last() const;

 private:
  void Load();
  void Compact();

  const std::filesystem::path file_;
  mutable std::mutex mutex_;
  std::vector<message::HistoryEntry> steps_;
  std::uint64_t last_id_ = 0;
};

}  // namespace tendon
