#pragma once

#include <tendon/payload/encoded_size.h>
#include <tendon/payload/payload.h>
#include <tendon/state/row_ring.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>

namespace tendon {

/// The position of a column's cell in a row. A cell is the CDR body of a value. If the type is
/// dynamic, one word precedes the body: the length of the body, or kAbsent.
struct CellLayout {
  static constexpr std::uint64_t kAbsent = ~std::uint64_t{0};

  std::size_t offset = 0;  ///< offset in the row, in words
  std::size_t words = 0;   ///< number of words, including the length word
  std::size_t bytes = 0;   ///< size of the body; the maximum size if the type is dynamic
  bool is_dynamic = false;

  bool operator==(const CellLayout&) const = default;
};

/// Returns true if the bytes of `value` in memory are the bytes of its encoding. This is the case
/// if T consists only of numbers, in the order of its description and without padding. For most
/// types the compiler turns this function into a constant.
template <FixedPayload T>
bool LiesAsOnWire(const T& value) noexcept {
  if constexpr (!std::is_trivially_copyable_v<T> || sizeof(T) != kEncodedSize<T>) {
    return false;
  } else if constexpr (payload::Structure<T>) {
    const auto* position = reinterpret_cast<const std::byte*>(&value);
    const auto is_next = [&](const auto& member) {
      const bool is_here = reinterpret_cast<const std::byte*>(&member) == position;
      position += sizeof(member);
      return is_here && LiesAsOnWire(member);
    };
    return payload::WithFields<T>([&](const auto&... field) {
      return sizeof...(field) > 0 && (is_next(field.Of(value)) && ...);
    });
  } else {
    return payload::IsPlain<T>();
  }
}

inline void LoadWord(const RowRing<>::Word& word, std::byte* bytes) noexcept {
  const std::uint64_t value = word.load(std::memory_order_relaxed);
  std::memcpy(bytes, &value, sizeof(value));
}

/// Loads words one by one, without a loop.
template <std::size_t... kIndex>
void LoadWords(const RowRing<>::Word* words, std::byte* bytes,
               std::index_sequence<kIndex...> /*indices*/) noexcept {
  (LoadWord(words[kIndex], bytes + kIndex * sizeof(std::uint64_t)), ...);
}
template <>
inline void LoadWords(const RowRing<>::Word* /*words*/, std::byte* /*bytes*/,
                      std::index_sequence<> /*indices*/) noexcept {}

/// Loads a cell word by word into memory for `kBytes` bytes.
template <std::size_t kBytes>
void LoadCell(const RowRing<>::Word* cell, std::byte* bytes) noexcept {
  constexpr std::size_t kWord = sizeof(std::uint64_t);
  constexpr std::size_t kBlock = 8;  // words; the compiler does not unroll a loop over single words
  constexpr std::size_t kWords = kBytes / kWord;
  constexpr std::size_t kInBlocks = kWords / kBlock * kBlock;
  for (std::size_t i = 0; i < kInBlocks; i += kBlock) {
    LoadWords(cell + i, bytes + i * kWord, std::make_index_sequence<kBlock>());
  }
  LoadWords(cell + kInBlocks, bytes + kInBlocks * kWord,
            std::make_index_sequence<kWords - kInBlocks>());
  if constexpr (kBytes % kWord != 0) {
    const std::uint64_t word = cell[kWords].load(std::memory_order_relaxed);
    std::memcpy(bytes + kWords * kWord, &word, kBytes % kWord);
  }
}

/// Returns the buffer into which the calling thread reads rows, with a size of `words` words. Each
/// thread has one buffer and keeps it, so memory is allocated only if the buffer must grow.
std::span<std::uint64_t> RowBuffer(std::size_t words);

/// A reader's copy of one cell. The content is valid only if the check of the row's tick succeeds
/// after the copy.
template <Payload T>
class CellCopy {
 public:
  explicit CellCopy(const CellLayout& layout) : words_(RowBuffer(layout.words)) {}

  void Load(const RowRing<>::Word* cell) noexcept {
    words_[0] = cell[0].load(std::memory_order_relaxed);
    if (is_absent()) return;
    const std::size_t needed = (words_[0] + 7) / 8 + 1;  // arbitrary if the row was overwritten
    for (std::size_t i = 1; i < std::min(needed, words_.size()); ++i) {
      words_[i] = cell[i].load(std::memory_order_relaxed);
    }
  }
  [[nodiscard]] bool is_absent() const noexcept { return words_[0] == CellLayout::kAbsent; }
  [[nodiscard]] std::span<const std::byte> body() const noexcept {
    return std::as_bytes(words_.subspan(1)).first(words_[0]);
  }

 private:
  std::span<std::uint64_t> words_;
};

template <FixedPayload T>
class CellCopy<T> {
 public:
  explicit CellCopy(const CellLayout& /*layout*/) noexcept {}

  void Load(const RowRing<>::Word* cell) noexcept {
    LoadCell<kEncodedSize<T>>(cell, bytes_.data());
  }
  [[nodiscard]] static constexpr bool is_absent() noexcept { return false; }
  [[nodiscard]] std::span<const std::byte> body() const noexcept { return bytes_; }

 private:
  alignas(std::uint64_t) std::array<std::byte, kEncodedSize<T>> bytes_;
};

}  // namespace tendon
