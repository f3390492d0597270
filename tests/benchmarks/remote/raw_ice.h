#pragma once

#include <benchmarks/floors.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tendon::benchmark {

/// The comparison for calls between processes: ZeroC Ice by itself, used as its generated code uses
/// it. It has the settings of our own communicators and sockets, except for its threads, and no
/// frames, handles or credits.
class RawIceServer {
 public:
  RawIceServer();
  RawIceServer(const RawIceServer&) = delete;
  RawIceServer& operator=(const RawIceServer&) = delete;
  ~RawIceServer();

  /// For RawIce: calls are dispatched by a pool of threads that may grow, as raw Ice needs to serve
  /// others while a call is slow.
  [[nodiscard]] std::string address() const;
  /// Calls are dispatched by one thread, so a slow call delays all others.
  [[nodiscard]] std::string address_of_one_thread() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

/// Calls a RawIceServer over an existing connection. One thread at a time. Throws the exceptions of
/// Ice.
class RawIce {
 public:
  explicit RawIce(const std::string& address);
  RawIce(const RawIce&) = delete;
  RawIce& operator=(const RawIce&) = delete;
  ~RawIce();

  /// A two-way call without a parameter, answered with 64 bytes.
  void Read(Message& answer);
  /// Sends oneway calls, each in a separate message, and waits until the server has dispatched all
  /// of them.
  void Write(std::span<const std::byte> parameter, std::uint64_t times);
  /// The same, `size` of them in a message.
  void WriteBatches(std::span<const std::byte> parameter, std::uint64_t times, std::uint64_t size);
  /// Two-way, without waiting: `done` is called in a thread of Ice.
  void BeginRead(std::function<void(bool ok)> done);
  /// Where the bytes of a large answer are when it is requested: they stay in place, or the servant
  /// must first copy them into memory that it keeps.
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
