#pragma once

#include <tendon/payload/codec.h>

#include <cstddef>
#include <vector>

namespace tendon::test {

/// The encoded body of a value, as on the wire.
template <Payload T>
std::vector<std::byte> Encoded(const T& value) {
  std::vector<std::byte> body;
  Encode(value, body);
  return body;
}

}  // namespace tendon::test
