#pragma once

#include <benchmarks/floors.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tendon::benchmark {

/// A server of another project's middleware: answers each request with 64 bytes until it is
/// destroyed.
class RivalServer {
 public:
  RivalServer() = default;
  RivalServer(const RivalServer&) = delete;
  RivalServer& operator=(const RivalServer&) = delete;
  virtual ~RivalServer() = default;

  /// The address for Rival::reach; one word.
  [[nodiscard]] virtual std::string address() const = 0;
};

/// The client, which is already connected. One thread at a time.
class RivalClient {
 public:
  RivalClient() = default;
  RivalClient(const RivalClient&) = delete;
  RivalClient& operator=(const RivalClient&) = delete;
  virtual ~RivalClient() = default;

  /// Sends a request and waits for the reply; throws if there is none in time.
  virtual void Read(Message& reply) = 0;
};

/// A middleware that Tendon is compared with in addition to raw Ice; available if its package was
/// found when this was built.
struct Rival {
  std::string id;      ///< the id of its benchmark case
  std::string name;    ///< the name in the report
  double stretch = 0;  ///< the goal: the time of Tendon divided by the time of this middleware
  std::string
      /// The missing package; if empty, the middleware is built in and the functions below are set.
      missing;
  std::function<std::unique_ptr<RivalServer>()> serve;
  std::function<std::unique_ptr<RivalClient>(const std::string& address)> reach;
};

Rival ZeroMq();
Rival CycloneDds();

/// Returns all other middlewares.
std::vector<Rival> Rivals();

}  // namespace tendon::benchmark
