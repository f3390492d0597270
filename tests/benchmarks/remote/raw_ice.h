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
/// it. It has the settings of Tendon's communicators and sockets, except for its threads, and no
/// frames, handles or credits.
class RawIceServer {
 public:
  RawIceServer();
  RawIceServer(const RawIceServer&) = delete;
  RawIceServer& operator=(const RawIceServer&) = delete;
  ~RawIceServer();

  /// The address of a server with a thread pool that may grow. Raw Ice needs such a pool to serve
  /// other callers while a call is slow.
  [[nodiscard]] std::string address() const;
  /// The address of a server with one thread: a slow call delays all others.
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
  void Read(Message& reply);
  /// Sends oneway calls, each in a separate message, and waits until the server has dispatched all
  /// of them.
  void Write(std::span<const std::byte> parameter, std::uint64_t times);
  /// Sends the same calls, `size` of them in each message.
  void WriteBatches(std::span<const std::byte> parameter, std::uint64_t times, std::uint64_t size);
  /// Begins a two-way call without waiting: `done` is called in a thread of Ice.
  void BeginRead(std::function<void(bool ok)> done);
  /// The memory of a large reply: kThere means that the bytes stay in place; kCopiedFirst means
  /// that the servant first copies them into memory that it keeps.
  enum class Image { kThere, kCopiedFirst };
  /// A two-way call that is answered with 1 MiB; returns how many bytes came.
  std::size_t ReadImage(Image image);
  /// Makes a new connection, and one call on it. Returns the time in nanoseconds.
  double Connect();

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

/// The size of a large reply.
inline constexpr std::size_t kImageBytes = std::size_t{1} << 20U;

}  // namespace tendon::benchmark
