#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace tendon {

/// The argument of one call, before it is encoded. The command chooses the memory into which the
/// argument is encoded, so no copy is needed. One thread uses this object, during the call.
class ArgumentWriter {
 public:
  ArgumentWriter() = default;
  ArgumentWriter(const ArgumentWriter&) = delete;
  ArgumentWriter& operator=(const ArgumentWriter&) = delete;
  virtual ~ArgumentWriter() = default;

  /// Returns the size of the encoded argument, in bytes.
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// Encodes the argument into `place`, which has size() bytes. Returns false if the size of the
  /// argument has changed since size() was called. Throws the exceptions of the codec.
  [[nodiscard]] virtual bool WriteTo(std::span<std::byte> place) const = 0;
  /// Returns the encoded argument. It is in memory of the caller and valid during the call. Throws
  /// the exceptions of the codec.
  [[nodiscard]] virtual std::span<const std::byte> Encoded() const = 0;
};

/// An argument that is already encoded.
class EncodedArgument final : public ArgumentWriter {
 public:
  explicit EncodedArgument(std::span<const std::byte> bytes) : bytes_(bytes) {}

  [[nodiscard]] std::size_t size() const override { return bytes_.size(); }
  [[nodiscard]] bool WriteTo(std::span<std::byte> place) const override {
    std::ranges::copy(bytes_, place.begin());
    return true;
  }
  [[nodiscard]] std::span<const std::byte> Encoded() const override { return bytes_; }

 private:
  std::span<const std::byte> bytes_;
};

}  // namespace tendon
