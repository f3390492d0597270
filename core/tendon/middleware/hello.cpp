#include <tendon/middleware/hello.h>

#include <tendon/base/os/file.h>
#include <tendon/base/os/process.h>
#include <tendon/base/text.h>
#include <tendon/middleware/body.h>

#include <array>
#include <charconv>
#include <utility>

namespace tendon {
Result<std::uint64_t> LoopbackCookie() {
  constexpr int kHex = 16;
  std::array<char, 17> fresh{};
  const std::uint64_t random = os::RandomNumber() | 1U;  // 0 is no cookie
  const char* end = std::to_chars(fresh.data(), fresh.data() + fresh.size(), random, kHex).ptr;
  const auto file = os::RuntimeFolder() / "cookie";

  const auto text = os::ReadOrMakePrivateFile(file, std::string(std::as_const(fresh).data(), end));
  if (!text) return text.error();

  std::uint64_t cookie = 0;
  const char* last = text->data() + text->size();
  const auto [rest, failure] = std::from_chars(text->data(), last, cookie, kHex);
  if (failure != std::errc{} || rest != last || cookie == 0) {
    return Error{ErrorCode::kInvalid,
                 file.string() + " is damaged: remove this file, then start the program again"};
  }
  return cookie;
}

Error ReadRefusal(std::span<const std::byte> body, const std::string& peer) {
  Error error;
  if (Decode(body, error)) return {error.code, Printable(error.message)};
  return {ErrorCode::kFailed,
          peer + " refused the request, but the reason that it sent cannot be read"};
}

}  // namespace tendon
