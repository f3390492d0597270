#pragma once

#include <QString>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

namespace tendon::gui {

/// Something that happened, at a moment on the axis of all plots.
struct Mark {
  enum class Kind { kCommand, kEvent, kState, kConnection };

  Kind kind = Kind::kEvent;
  std::int64_t time_ns = 0;  ///< on this process' steady clock, as samples have it
  QString label;             ///< short, at the foot of the plot: "MoveTo"
  QString text;              ///< all of it: "call robot/arm/Control.MoveTo {…}"
  bool is_bad = false;       ///< refused, faulted, lost

  bool operator==(const Mark&) const = default;
};

/// The newest marks, oldest first, for all plots together. GUI thread.
class MarkTrack {
 public:
  static constexpr std::size_t kMost = 4096;

  using Iterator = std::deque<Mark>::const_iterator;

  /// May come out of order. O(1) for the newest.
  void add(Mark mark);
  /// Those in [from_ns, to_ns].
  [[nodiscard]] std::pair<Iterator, Iterator> between(std::int64_t from_ns,
                                                      std::int64_t to_ns) const;
  [[nodiscard]] const std::deque<Mark>& all() const { return marks_; }

 private:
  std::deque<Mark> marks_;
};

}  // namespace tendon::gui
