#include <tendon/ice/bounded_reader.h>

#include <algorithm>
#include <cassert>
#include <limits>

namespace tendon::ice {
namespace {

void AppendInt(std::int32_t value, Bytes& bytes) {
  const auto raw = std::as_bytes(std::span(&value, 1));
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

}  // namespace

std::optional<std::span<const std::byte>> ReadOnlyParameter(
    std::span<const std::byte> encapsulation) {
  BoundedReader reader(encapsulation);
  const auto claimed = reader.ReadInt();
  if (!claimed || *claimed < 0 || static_cast<std::size_t>(*claimed) != encapsulation.size()) {
    return std::nullopt;
  }
  const auto major = reader.ReadByte();
  const auto minor = reader.ReadByte();
  if (major != 1 || !minor || *minor > 1) return std::nullopt;
  const auto size = reader.ReadSize();
  if (!size) return std::nullopt;
  const auto parameter = reader.ReadBytes(*size);
  return reader.AtEnd() ? parameter : std::nullopt;
}

void WriteOnlyParameter(std::span<const std::byte> parameter, Bytes& encapsulation) {
  constexpr std::size_t kHeader = 6;
  constexpr std::size_t kLongSize = BoundedReader::kLongSize;
  const std::size_t prefix = parameter.size() < kLongSize ? 1 : 5;
  const std::size_t total = kHeader + prefix + parameter.size();
  assert(total <= std::numeric_limits<std::int32_t>::max());
  encapsulation.clear();
  encapsulation.reserve(total);
  AppendInt(static_cast<std::int32_t>(total), encapsulation);
  encapsulation.push_back(std::byte{1});
  encapsulation.push_back(std::byte{1});
  encapsulation.push_back(static_cast<std::byte>(std::min(parameter.size(), kLongSize)));
  if (prefix > 1) AppendInt(static_cast<std::int32_t>(parameter.size()), encapsulation);
  encapsulation.insert(encapsulation.end(), parameter.begin(), parameter.end());
}

}  // namespace tendon::ice
