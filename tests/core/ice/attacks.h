#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "core/ice/raw_ice.h"

namespace tendon::ice {

inline constexpr std::int64_t kHugeSize = 0x7fffffff;

inline RawMessage Request(std::string_view operation = "frame", int request = 1) {
  return RawMessage(RawMessage::kRequest).Target(operation, request);
}

/// Returns parameters with a sequence that claims `size` bytes but has four.
inline RawMessage WithSequence(std::int64_t size, int request = 1) {
  return Request("frame", request).Int(15).Byte(1).Byte(1).Size(size).Text("body");
}

inline RawMessage WithEncapsulation(std::int64_t size) {
  return Request().Int(size).Byte(1).Byte(1).Byte(0);
}

/// Returns a parameter with a proxy for another host. A program that called this proxy back would
/// connect to that host.
inline RawMessage WithProxy(std::int64_t endpoints) {
  RawMessage request = Request().Int(32).Byte(1).Byte(1).String("tendon").String("").Byte(0);
  return request.Int(0).Int(0x00010001).Size(endpoints).Text("evil");
}

/// 64 MiB of zeros, compressed with bzip2: valid, but too large.
inline constexpr std::string_view kBomb(
    "\x42\x5a\x68\x39\x31\x41\x59\x26\x53\x59\x0e\x09\xe2\xdf\x01\x5f\x8e\x40\x00\xc0"
    "\x00\x00\x08\x20\x00\x30\x80\x4d\x46\x42\xa0\x25\xa9\x0a\x80\x97\x31\x41\x59\x26"
    "\x53\x59\xbc\x04\xb5\xc3\x00\xa2\x75\xc0\x00\xc0\x00\x00\x08\x20\x00\x20\xa4\x08"
    "\x36\x32\x8a\x88\x4d\x2a\x2a\x21\x38\xbb\x92\x29\xc2\x84\x85\x00\xbb\x83\xe8",
    79);

/// Returns a compressed request that claims this uncompressed size.
inline RawMessage Bomb(std::int64_t size) {
  return RawMessage(RawMessage::kRequest, 2).Int(size).Text(kBomb);
}

/// Returns malformed requests by name: one of every kind that is known to harm programs with Ice.
inline std::map<std::string, Bytes> Attacks() {
  const auto message = [](RawMessage::Type type) { return RawMessage(type); };
  const auto request = [&] { return message(RawMessage::kRequest).Int(1); };
  std::map<std::string, Bytes> attacks;
  for (const std::int64_t size : {kHugeSize, kHugeSize - 6, std::int64_t{-1},
                                  std::int64_t{0x20000000}, std::int64_t{5}, std::int64_t{3}}) {
    attacks["sequence of " + std::to_string(size)] = WithSequence(size).Finished();
    attacks["oneway, sequence of " + std::to_string(size)] = WithSequence(size, 0).Finished();
  }
  for (const std::int64_t size : {kHugeSize, std::int64_t{-5}, std::int64_t{0}, std::int64_t{5},
                                  std::int64_t{6}, std::int64_t{8}, std::int64_t{100000}}) {
    attacks["encapsulation of " + std::to_string(size)] = WithEncapsulation(size).Finished();
  }
  for (const std::int64_t size : {kHugeSize, std::int64_t{-1}, std::int64_t{5}, std::int64_t{0}}) {
    attacks["message of " + std::to_string(size)] = WithSequence(4).Claiming(size);
    attacks["batch of " + std::to_string(size)] =
        message(RawMessage::kBatch).Int(size).String("tendon").Finished();
    attacks["name of " + std::to_string(size)] = request().Size(size).Text("tendon").Finished();
    attacks["facets: " + std::to_string(size)] =
        request().String("tendon").String("").Size(size).Finished();
    attacks["contexts: " + std::to_string(size)] =
        request().String("tendon").String("").Byte(0).String("frame").Byte(0).Size(size).Finished();
    attacks["a proxy of so many endpoints: " + std::to_string(size)] = WithProxy(size).Finished();
    attacks["compressed from " + std::to_string(size)] =
        RawMessage(RawMessage::kRequest, 2).Int(size).Text("BZh91AY&SYjunkjunkjunk").Finished();
  }
  for (const std::int64_t size :
       {std::int64_t{64} << 20U, std::int64_t{200} << 10U, kHugeSize, std::int64_t{14}}) {
    attacks["a bomb of " + std::to_string(size)] = Bomb(size).Finished();
  }
  attacks["no parameters"] = Request().Int(6).Byte(1).Byte(1).Finished();
  attacks["no frame"] = Request().Int(11).Byte(1).Byte(1).String("body").Finished();
  attacks["a type of 2 GB"] =
      Request("ice_isA").Int(15).Byte(1).Byte(1).Size(kHugeSize).Text("body").Finished();
  attacks["an answer to no question"] = message(RawMessage::kReply).Int(77).Byte(0).Finished();
  attacks["an unknown kind"] = message(static_cast<RawMessage::Type>(99)).Finished();
  return attacks;
}

}  // namespace tendon::ice
