#pragma once

#include <benchmarks/floors.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tendon::benchmark {

/// What we are compared with between processes: ZeroC Ice by itself, with the settings of our own
/// communicators and sockets, but for its threads, and used as its generated code uses it. Knows
/// nothing of frames, handles or credits.
class RawIceServer {
 public:
  RawIceServer();
  RawIceServer(const RawIceServer&) = delete;
  RawIceServer& operator=(const RawIceServer&) = delete;
  ~RawIceServer();

  /// For RawIce: where a pool of threads dispatches that may grow, which is how raw Ice serves
  /// others while a call is slow.
  [[nodiscard]] std::string address() const;
  /// Where one thread does, which a slow call holds up for all.
  [[nodiscard]] std::string address_of_one_thread() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

/// Calls a RawIceServer, over a connection that is there already. One thread at a time. Throws what
/// Ice throws.
class RawIce {
 public:
  explicit RawIce(const std::string& address);
  RawIce(const RawIce&) = delete;
  RawIce& operator=(const RawIce&) = delete;
  ~RawIce();

  /// A two-way call without a parameter, answered with 64 bytes.
  void Read(Message& answer);
  /// Oneways, each a message of its own, until all have been dispatched over there.
  void Write(std::span<const std::byte> parameter, std::uint64_t times);
  /// The same, `size` of them in a message.
  void WriteBatches(std::span<const std::byte> parameter, std::uint64_t times, std::uint64_t size);
  /// Two-way, without waiting: `done` is called in a thread of Ice.
  void BeginRead(std::function<void(bool ok)> done);
  /// Where the bytes of a large answer are when it is asked for: where they stay, or where the
  /// servant has to copy them first into memory that it keeps.
  enum class Image { kThere, kCopiedFirst };
  /// A two-way call that is answered with 1 MiB; returns how many bytes came.
  std::size_t ReadImage(Image image);
  /// Makes a new connection, and one call on it; returns the nanoseconds that took.
  double Connect();

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

/// Of a large answer.
inline constexpr std::size_t kImageBytes = std::size_t{1} << 20U;

}  // namespace tendon::benchmark
