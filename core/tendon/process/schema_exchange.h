#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/process/messages.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>

namespace tendon {

/// Answers kGetSchemas with what this process knows. Refuses a question for more than 1024.
void AnswerSchemas(std::span<const std::byte> body, Responder& responder);

/// The schemas in an answer of any origin, by their fingerprints: those that were asked for and
/// whose texts are what the fingerprints say.
[[nodiscard]] std::map<Fingerprint, Schema> ReadSchemas(const message::GetSchemas& asked,
                                                        const message::Schemas& answer);

/// What FindSchema() is told of types that peers know, for the life of the process. It keeps no
/// more than it was allowed, whatever they say. Thread-safe.
class LearnedSchemas {
 public:
  /// How much it keeps at most.
  struct Limits {
    std::size_t types = 4096;
    std::size_t text = std::size_t{16} << 20U;  ///< bytes of all their texts
  };

  explicit LearnedSchemas(Limits limits) : limits_(limits) {}

  /// FindSchema() knows it from now on. False when this would be too much, which is warned of once.
  bool Learn(const Schema& schema);

 private:
  const Limits limits_;
  std::mutex mutex_;
  std::size_t types_ = 0;
  std::size_t text_ = 0;
  bool has_warned_ = false;
};

/// Asks the peer; FindSchema() knows from then on what it told, within LearnedSchemas's usual
/// limits for all peers together. `done` is called once, whatever
/// came. `timer` sees to that.
void LearnSchemas(Worker& timer, const std::shared_ptr<Channel>& channel,
                  const message::GetSchemas& wanted, std::chrono::milliseconds timeout,
                  std::function<void()> done);

}  // namespace tendon
