#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace tendon::volume {

/// The number of items that each test passes; set by the option `--items=N`.
inline std::uint64_t items = 0;

/// The queue length. It is so large that two threads rarely wait for each other, even if they share
/// a processor with other programs.
inline constexpr std::size_t kCapacity = 8192;

/// A cache line whose words are computed from its number, each by another rule. So a mixture of two
/// items is detected.
using Item = std::array<std::uint64_t, 7>;

constexpr Item ItemOf(std::uint64_t number) {
  constexpr std::uint64_t kOdd = 0x9E37'79B9'7F4A'7C15;
  Item item{number};
  for (std::size_t i = 1; i < item.size(); ++i) item[i] = item[i - 1] * kOdd + i;
  return item;
}

/// Receives items, and compares them with the expected ones.
class Checker {
 public:
  void Take(const Item& item) {
    if (item != ItemOf(item[0])) ++torn_;
    if (item[0] > next_) lost_ += item[0] - next_;
    if (item[0] < next_) ++repeated_or_late_;
    next_ = item[0] + 1;
  }

  [[nodiscard]] std::uint64_t next() const { return next_; }
  [[nodiscard]] std::uint64_t torn() const { return torn_; }
  [[nodiscard]] std::uint64_t lost() const { return lost_; }
  [[nodiscard]] std::uint64_t repeated_or_late() const { return repeated_or_late_; }

 private:
  std::uint64_t next_ = 0;
  std::uint64_t torn_ = 0;
  std::uint64_t lost_ = 0;
  std::uint64_t repeated_or_late_ = 0;
};

}  // namespace tendon::volume
