#pragma once

#include <tendon/payload/payload.h>
#include <tendon/payload/schema.h>

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tendon {

/// Identifies a payload's type between processes: 128-bit XXH3 of its canonical schema text.
struct Fingerprint {
  std::uint64_t high = 0;
  std::uint64_t low = 0;

  auto operator<=>(const Fingerprint&) const = default;
};
template <>
inline constexpr auto kPayload<Fingerprint> = Describe("tendon.Fingerprint",
                                                       Field{"high", &Fingerprint::high},
                                                       Field{"low", &Fingerprint::low});

/// Returns 32 hexadecimal digits.
[[nodiscard]] std::string ToString(Fingerprint fingerprint);

[[nodiscard]] Fingerprint FingerprintOf(std::string_view canonical_schema_text);

namespace payload {
/// Stores `schema` for FindSchema() and returns its fingerprint.
Fingerprint Remember(const Schema& schema);
}  // namespace payload

/// Returns the fingerprint of a type, which is computed at the first call. Thread-safe.
template <Payload T>
[[nodiscard]] const Fingerprint& FingerprintOf() {
  static const Fingerprint fingerprint = payload::Remember(SchemaOf<T>());
  return fingerprint;
}

/// Returns the schema with this fingerprint, if this process has computed FingerprintOf() for its
/// type or has received the schema from another process. Thread-safe.
[[nodiscard]] std::optional<Schema> FindSchema(Fingerprint fingerprint);

}  // namespace tendon
