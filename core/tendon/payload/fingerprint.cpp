#include <tendon/payload/fingerprint.h>

#include <xxhash.h>

#include <array>
#include <cinttypes>
#include <cstdio>
#include <map>
#include <mutex>

namespace tendon {
namespace {

struct KnownSchemas {
  std::mutex mutex;
  std::map<Fingerprint, Schema> schemas;
};

KnownSchemas& Known() {
  static KnownSchemas known;
  return known;
}

}  // namespace

std::string ToString(Fingerprint fingerprint) {
  std::array<char, 33> digits{};
  std::snprintf(digits.data(), digits.size(), "%016" PRIx64 "%016" PRIx64, fingerprint.high,
                fingerprint.low);
  return digits.data();
}

Fingerprint FingerprintOf(std::string_view canonical_schema_text) {
  const XXH128_hash_t hash =
      XXH3_128bits(canonical_schema_text.data(), canonical_schema_text.size());
  return {hash.high64, hash.low64};
}

Fingerprint payload::Remember(const Schema& schema) {
  const Fingerprint fingerprint = schema.fingerprint();
  const std::scoped_lock lock(Known().mutex);
  Known().schemas.emplace(fingerprint, schema);
  return fingerprint;
}

std::optional<Schema> FindSchema(Fingerprint fingerprint) {
  const std::scoped_lock lock(Known().mutex);
  const auto found = Known().schemas.find(fingerprint);
  if (found == Known().schemas.end()) return std::nullopt;
  return found->second;
}

}  // namespace tendon
