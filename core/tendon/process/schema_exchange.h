#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/process/viewer_messages.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>

namespace tendon {

/// Replies to kGetSchemas with the schemas that this process knows. Refuses requests for more than
/// 1024.
void ReplyWithSchemas(std::span<const std::byte> body, Responder& responder);

/// Reads the schemas in an untrusted reply. Returns only the schemas that were requested and whose
/// text matches the fingerprint.
[[nodiscard]] std::map<Fingerprint, Schema> ReadSchemas(const message::GetSchemas& asked,
                                                        const message::Schemas& reply);

/// Stores the types that peers describe, so that FindSchema() finds them until the process ends.
/// Its size is limited, so peers cannot use up the memory. Thread-safe.
class SchemaCache {
 public:
  /// The limits of a SchemaCache.
  struct Limits {
    std::size_t types = 4096;
    std::size_t text = std::size_t{16} << 20U;  ///< bytes of all texts
  };

  explicit SchemaCache(Limits limits) : limits_(limits) {}

  /// Adds a type, so that FindSchema() finds it. Returns false, and logs this once, if the type
  /// would exceed the limits.
  bool Learn(const Schema& schema);

 private:
  const Limits limits_;
  std::mutex mutex_;
  std::size_t types_ = 0;
  std::size_t text_ = 0;
  bool has_warned_ = false;
};

/// Asks the peer for schemas and adds them, so that FindSchema() finds them. The default limits of
/// SchemaCache apply to all peers together. Calls `done` exactly once, even after an error. `timer`
/// provides the timeout.
void LearnSchemas(Worker& timer, const std::shared_ptr<Channel>& channel,
                  const message::GetSchemas& wanted, std::chrono::milliseconds timeout,
                  std::function<void()> done);

}  // namespace tendon
