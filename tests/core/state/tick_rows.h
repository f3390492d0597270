#pragma once

#include <tendon/state/row_ring.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace tendon_test {

/// For simulations: a ring of two rows of two words. Both words hold the tick of the row.
template <typename Atomics>
struct TickRows {
  using Words = std::array<std::uint64_t, 2>;

  tendon::RowRing<Atomics> ring;

  TickRows() { ring.Allocate(1, 2); }

  void Write(std::uint64_t tick) {
    ring.Begin(static_cast<std::int64_t>(tick));
    const Words words{tick, tick};
    ring.Store(0, words);
    ring.Publish();
  }
  static auto Into(Words& words) {
    return [&words](const auto* row) {
      for (std::size_t i = 0; i < words.size(); ++i) {
        words[i] = row[i].load(std::memory_order_relaxed);
      }
    };
  }
};

}  // namespace tendon_test
