#include <tendon/base/os/private_file.h>
#include <tendon/base/os/process.h>
#include <tendon/middleware/body.h>
#include <tendon/middleware/hello.h>

#include <array>
#include <charconv>
#include <utility>

namespace tendon {
namespace {

/// In the words of the one who opened the link.
Error VersionsDiffer(const std::string& acceptor, unsigned its_version, unsigned openers_version) {
  return {ErrorCode::kIncompatible,
          acceptor + " speaks protocol " + std::to_string(its_version) + ", this program " +
              std::to_string(openers_version) + ": update " +
              (its_version > openers_version ? "this program" : acceptor)};
}

bool IsWelcome(const Hello& peer, const Hello& mine, Strangers strangers) {
  if (strangers == Strangers::kFromElsewhere) return true;
  if (peer.cookie == 0) return strangers == Strangers::kAllowed;
  return peer.cookie == mine.cookie;
}

}  // namespace

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
    return Error{ErrorCode::kInvalid, file.string() + " is damaged: remove it, then start again"};
  }
  return cookie;
}

Result<Hello> CheckHello(const FrameHeader& header, std::span<const std::byte> body,
                         const Hello& mine, Strangers strangers) {
  if (header.type != MessageType::kHello || header.request == 0) {
    return Error{ErrorCode::kInvalid, mine.name + " expects a Hello first"};
  }
  if (header.version != mine.protocol_version) {
    return VersionsDiffer(mine.name, mine.protocol_version, header.version);
  }
  auto hello = DecodeBody<Hello>(body);
  if (hello && !IsWelcome(*hello, mine, strangers)) {
    return Error{ErrorCode::kDenied, mine.name + " does not know '" + hello->name +
                                         "': both must run as the same user of this machine"};
  }
  return hello;
}

Result<Hello> CheckWelcome(const FrameHeader& header, std::span<const std::byte> body,
                           const Hello& sent, const std::string& peer) {
  if (header.type == MessageType::kRefusal) return ReadRefusal(body, peer);
  if (header.version != sent.protocol_version) {
    return VersionsDiffer(peer, header.version, sent.protocol_version);
  }
  auto hello = DecodeBody<Hello>(body);
  if (header.type != MessageType::kWelcome || !hello) {
    return Error{ErrorCode::kInvalid, peer + " answered the Hello with something else"};
  }
  if (hello->cookie != sent.cookie) {
    return Error{ErrorCode::kDenied, hello->name + " at " + peer + " runs as another user"};
  }
  return hello;
}

Error ReadRefusal(std::span<const std::byte> body, const std::string& peer) {
  Error error;
  if (Decode(body, error)) return error;
  return {ErrorCode::kFailed, peer + " refused, and its reason cannot be read"};
}

}  // namespace tendon
