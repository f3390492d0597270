#pragma once

#include <QString>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

namespace tendon::gui {

/// An event at one time, shown in all plots.
struct Mark {
  enum class Kind { kCommand, kEvent, kState, kConnection };

  Kind kind = Kind::kEvent;
  std::int64_t time_ns = 0;  ///< on this process's steady clock, like samples
  QString label;             ///< short, at the foot of the plot: "MoveTo"
  QString text;              ///< full text: "call robot/arm/Control.MoveTo {…}"
  bool is_bad = false;       ///< refused, faulted, lost

  bool operator==(const Mark&) const = default;
};

/// The newest marks, oldest first, for all plots together. GUI thread.
class MarkTrack {
 public:
  static constexpr std::size_t kMost = 4096;

  using Iterator = std::deque<Mark>::const_iterator;

  /// May be called out of order. O(1) for the newest mark.
  void add(Mark mark);
  /// The marks in [from_ns, to_ns].
  [[nodiscard]] std::pair<Iterator, Iterator> between(std::int64_t from_ns,
                                                      std::int64_t to_ns) const;
  [[nodiscard]] const std::deque<Mark>& all() const { return marks_; }

 private:
  std::deque<Mark> marks_;
};

}  // namespace tendon::gui
