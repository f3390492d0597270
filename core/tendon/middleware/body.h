#pragma once

#include <tendon/base/result.h>
#include <tendon/middleware/frame.h>
#include <tendon/payload/codec.h>

#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace tendon {

template <>
inline constexpr auto kPayload<ErrorCode> = DescribeEnum(
    "tendon.ErrorCode", Enumerator{"FAILED", ErrorCode::kFailed},
    Enumerator{"INVALID", ErrorCode::kInvalid}, Enumerator{"UNREACHABLE", ErrorCode::kUnreachable},
    Enumerator{"NOT_FOUND", ErrorCode::kNotFound}, Enumerator{"EXISTS", ErrorCode::kExists},
    Enumerator{"INCOMPATIBLE", ErrorCode::kIncompatible},
    Enumerator{"TIMEOUT", ErrorCode::kTimeout}, Enumerator{"DENIED", ErrorCode::kDenied});

template <>
inline constexpr auto kPayload<Error> = Describe("tendon.Error", Field{"code", &Error::code},
                                                 Field{"message", &Error::message});

/// A payload that forms the whole body of a frame. A vector of bytes is no Message, because it is
/// already an encoded body.
template <typename T>
concept Message = Payload<T> && !std::convertible_to<const T&, std::span<const std::byte>>;

template <Message T>
[[nodiscard]] Bytes EncodeBody(const T& value) {
  Bytes body;
  Encode(value, body);
  return body;
}

/// Decodes a body. Fails with kInvalid if the bytes are not a valid T; the error names the type.
/// Use ReadRefusal() to decode an Error.
template <Payload T>
Result<T> DecodeBody(std::span<const std::byte> body) {
  T value{};
  if (Decode(body, value)) return Result<T>(std::move(value));
  std::string type = "its type";
  if constexpr (Described<T>) type = kPayload<T>.name;
  return Error{ErrorCode::kInvalid,
               "a message of " + std::to_string(body.size()) + " bytes does not decode as " + type};
}

}  // namespace tendon
