#pragma once

#include <QString>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

namespace tendon::gui {

/// A mark at one time, shown in all plots.
struct Mark {
  enum class Kind { kCommand, kEvent, kState, kConnection };

  Kind kind = Kind::kEvent;
  std::int64_t time_ns = 0;  ///< on the steady clock of this process, like the times of samples
  QString label;             ///< short text at the bottom of the plot: "MoveTo"
  QString text;              ///< full text: "call robot/arm/Control.MoveTo {…}"
  bool is_bad = false;       ///< refused, faulted, lost

  bool operator==(const Mark&) const = default;
};

/// The newest marks for all plots, oldest first. GUI thread.
class MarkTrack {
 public:
  static constexpr std::size_t kMax = 4096;

  using Iterator = std::deque<Mark>::const_iterator;

  /// Adds a mark. Marks need not be added in the order of time. O(1) if the mark is the newest.
  void add(Mark mark);
  /// Returns the marks within [from_ns, to_ns].
  [[nodiscard]] std::pair<Iterator, Iterator> between(std::int64_t from_ns,
                                                      std::int64_t to_ns) const;
  void clear() { marks_.clear(); }
  [[nodiscard]] const std::deque<Mark>& all() const { return marks_; }

 private:
  std::deque<Mark> marks_;
};

}  // namespace tendon::gui
