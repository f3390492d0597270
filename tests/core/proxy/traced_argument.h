#pragma once

#include <gtest/gtest.h>
#include <tendon/interface/command.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <span>
#include <vector>

namespace tendon {

/// An argument whose bytes all have the value `fill`. Records the address to which it is written.
class TracedArgument final : public ArgumentWriter {
 public:
  explicit TracedArgument(std::size_t size, std::byte fill = {}) : size_(size), fill_(fill) {}

  [[nodiscard]] std::size_t size() const override { return size_; }
  [[nodiscard]] bool WriteTo(std::span<std::byte> place) const override {
    EXPECT_EQ(place.size(), size_);
    if (throws) throw std::bad_alloc();
    std::ranges::fill(place, fill_);
    places.push_back(place.data());
    return !changes;
  }
  [[nodiscard]] std::span<const std::byte> Encoded() const override {
    ADD_FAILURE() << "the argument was encoded elsewhere";
    return {};
  }

  bool throws = false;
  bool changes = false;  ///< true: the size changes between size() and WriteTo()
  mutable std::vector<const std::byte*> places;

 private:
  std::size_t size_;
  std::byte fill_;
};

}  // namespace tendon
