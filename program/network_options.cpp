#include <program/network_options.h>

#include <tendon/base/os/process.h>
#include <tendon/base/text.h>
#include <tendon/middleware/tcp.h>
#include <tendon/process/process.h>
#include <tendon/security/credentials.h>

#ifdef TENDON_WITH_ICE
#include <tendon/ice/ice_middleware.h>
#endif

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <functional>
#include <utility>

namespace program {
namespace {

using tendon::Credentials;
using tendon::Error;
using tendon::ErrorCode;
using tendon::Exposure;
using tendon::Middleware;
using tendon::Result;
using MiddlewareResult = Result<std::unique_ptr<Middleware>>;

struct MiddlewareFactory {
  std::string name;
  std::function<std::unique_ptr<Middleware>(Exposure)> plain;
  std::function<MiddlewareResult(const Credentials&)> under_tls;
};

MiddlewareResult HasNoTls(const Credentials& /*credentials*/) {
  return Error{ErrorCode::kInvalid,
               "middleware 'tcp' has no TLS: leave out --certificate (and $TENDON_CERTIFICATE), or "
               "use --middleware ice"};
}

/// The middlewares in this build, with the default first.
const std::vector<MiddlewareFactory>& Factories() {
  static const std::vector<MiddlewareFactory> kFactories = {
#ifdef TENDON_WITH_ICE
      {"ice", [](Exposure exposure) { return tendon::MakeIceMiddleware(exposure); },
       [](const Credentials& credentials) { return tendon::MakeIceMiddleware(credentials); }},
#endif
      {"tcp", &tendon::MakeTcpMiddleware, &HasNoTls},
  };
  return kFactories;
}

MiddlewareResult Make(const MiddlewareFactory& factory, const NetworkOptions& options) {
  if (options.certificate.empty()) {
    return factory.plain(options.insecure ? Exposure::kInsecure : Exposure::kLoopbackOnly);
  }
  return factory.under_tls({.certificate = options.certificate, .authority = AuthorityOf(options)});
}

}  // namespace

std::filesystem::path AuthorityOf(const NetworkOptions& options) {
  return options.authority.empty() ? tendon::os::StateFolder() / "ca"
                                   : std::filesystem::path(options.authority);
}

std::vector<std::string> MiddlewareNames() {
  std::vector<std::string> names;
  for (const MiddlewareFactory& factory : Factories()) names.push_back(factory.name);
  return names;
}

std::string IceVersion() {
#ifdef TENDON_WITH_ICE
  return tendon::IceVersion();
#else
  return {};
#endif
}

void AddNetworkOptions(CLI::App& app, NetworkOptions& options) {
  app.add_option("--middleware", options.middleware,
                 "middleware for the connections between processes")
      ->check(CLI::IsMember(MiddlewareNames()))
      ->capture_default_str();
  auto* certificate =
      app.add_option("--certificate", options.certificate,
                     "use TLS with this certificate (made by gcm cert issue); the file with its "
                     "key (.key) must be in the same folder")
          ->type_name("FILE")
          ->check([](const std::string& file) {
            return std::string(file.empty() ? "--certificate is empty: name a file" : "");
          });
  if (options.certificate.empty()) certificate->envname("TENDON_CERTIFICATE");
  auto* authority =
      app.add_option("--ca", options.authority,
                     "folder with ca.crt and crl.pem of the CA (default: a folder of the user)")
          ->type_name("FILE");
  if (options.authority.empty()) authority->envname("TENDON_CA");
  app.add_flag("--insecure", options.insecure,
               "allow unencrypted connections to and from other machines")
      ->excludes(certificate);
}

CLI::Option* AddGcmOption(CLI::App& app, std::string& gcm, const std::string& more) {
  const auto check_given = [](const std::string& address) -> std::string {
    if (!address.empty()) return {};  // the caller checks the address
    return "expected an address such as 127.0.0.1:10705, got ''";
  };
  return app
      .add_option("--gcm", gcm, "address of the GCM (default: $TENDON_GCM, 127.0.0.1:10705)" + more)
      ->check(check_given)
      ->type_name("ADDRESS");
}

Result<std::shared_ptr<Middleware>> MakeMiddleware(const NetworkOptions& options) {
  for (const MiddlewareFactory& factory : Factories()) {
    if (factory.name != options.middleware) continue;
    auto made = Make(factory, options);
    if (!made) return made.error();
    return std::shared_ptr<Middleware>(*std::move(made));
  }
  return Error{ErrorCode::kInvalid,
               "no middleware '" + options.middleware +
                   "' in this program; available: " + tendon::Joined(MiddlewareNames(), ", ")};
}

std::string GcmAddress(const std::string& option) {
  std::string address = option;
  // NOLINTNEXTLINE(concurrency-mt-unsafe): read only
  if (const char* known = std::getenv("TENDON_GCM"); address.empty() && known != nullptr) {
    address = known;
  }
  if (address.empty()) address = "127.0.0.1";
  const bool is_host = address.find(':') == std::string::npos || address.ends_with(']');
  return is_host ? address + ":" + std::to_string(tendon::kDefaultGcmPort) : address;
}

Result<void> CheckGcmAddress(const std::string& address, const NetworkOptions& options) {
  const std::string host = address.substr(0, address.rfind(':'));
  const bool is_word = !host.empty() && host.find_first_of(".:]") == std::string::npos;
  if (!is_word || host == "localhost" || options.insecure || !options.certificate.empty()) {
    return {};
  }
  return Error{ErrorCode::kInvalid,
               "--gcm: " + tendon::Quoted(host) +
                   " is not an address on this machine, such as 127.0.0.1:10705; "
                   "to use a host with this name, give a --certificate"};
}

tendon::Result<void> CheckOwnPort(const std::string& option, const std::string& address,
                                  const std::string& gcm) {
  const auto own = tendon::ParseAddress(address, 1);
  const auto other = tendon::ParseAddress(gcm, 1);
  if (!own || !other || ToString(*own) != ToString(*other)) return {};
  return Error{ErrorCode::kInvalid, option + " and --gcm are both " + ToString(*own) +
                                        ", but two programs cannot share a port; give " + option +
                                        " another port"};
}

}  // namespace program
