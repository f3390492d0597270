#pragma once

#include <gcm_console/command_line/word_kind.h>
#include <tendon/gcm/client.h>

#include <chrono>
#include <cstdint>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace console {

/// A request to a process, and the latest reply to it.
template <typename T>
struct CachedReply {
  std::uint64_t instance = 0;  ///< instance id of the process
  std::chrono::steady_clock::time_point since;
  std::future<tendon::Result<T>> reply = {};  ///< valid while a reply is expected
  std::optional<T> known = std::nullopt;
};

/// Returns words that only the processes know: parameters and their values, arguments of commands,
/// classes, plug-ins. Cached words are returned at once and are requested again in the background.
/// If a reply arrives too late for one call, the next call uses it. For one thread.
class LiveCompletion {
 public:
  /// `timeout` is the maximum time that one call may wait in total.
  explicit LiveCompletion(std::chrono::milliseconds timeout) : timeout_(timeout) {}

  /// Returns the words of a kind that is not a path. `before` contains the verb's arguments before
  /// this word; paths in it are absolute.
  std::vector<std::string> Of(tendon::GcmClient& client, WordKind kind,
                              const std::vector<std::string>& before);

 private:
  using TimePoint = std::chrono::steady_clock::time_point;

  const tendon::message::Classes* ClassesOf(tendon::GcmClient& client, const std::string& process);
  std::vector<std::string> OfAllProcesses(tendon::GcmClient& client, WordKind kind);
  std::vector<std::string> OfComponent(tendon::GcmClient& client, WordKind kind,
                                       const std::vector<std::string>& before);
  std::vector<std::string> OfCommand(tendon::GcmClient& client,
                                     const std::vector<std::string>& before);

  const std::chrono::milliseconds timeout_;
  TimePoint deadline_;
  std::map<std::string, CachedReply<tendon::message::Classes>> classes_;  // by process
  std::map<tendon::Fingerprint, CachedReply<tendon::Schema>> schemas_;
};

}  // namespace console
