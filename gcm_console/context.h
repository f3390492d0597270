#pragma once

#include <program/exit_code.h>
#include <tendon/base/result.h>
#include <tendon/gcm/client.h>

#include <chrono>
#include <iosfwd>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace console {

/// What holds for every verb, from the command line.
struct Settings {
  std::string gcm;
  std::string middleware;
  std::chrono::milliseconds timeout{2000};
  bool json = false;
  bool insecure = false;
};

/// Where a verb's output goes, and what it asks the GCM through.
class Context {
 public:
  Context(Settings settings, std::string verb, std::ostream& out, std::ostream& err, int columns);

  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] std::ostream& out() const { return out_; }
  /// For remarks that are no result.
  [[nodiscard]] std::ostream& err() const { return err_; }
  /// The width of the terminal that out() is, 0 where it is none.
  [[nodiscard]] int columns() const { return columns_; }

  tendon::Result<std::shared_ptr<tendon::Middleware>> middleware() const;
  /// A client that has seen the catalogue; made once.
  tendon::Result<tendon::GcmClient*> Client();

  /// One JSON document, with "schema": 1 as its first key.
  void PrintJson(const nlohmann::ordered_json& content) const;

 private:
  Settings settings_;
  std::string verb_;
  std::ostream& out_;
  std::ostream& err_;
  int columns_;
  std::unique_ptr<tendon::GcmClient> client_;
};

}  // namespace console
