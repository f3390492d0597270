#pragma once

#include <tendon/base/result.h>
#include <tendon/middleware/middleware.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
class Option;
}  // namespace CLI

namespace program {

/// The middlewares this program was built with, the default first: "ice" where Ice is built in, and
/// "tcp".
std::vector<std::string> MiddlewareNames();

/// Of the Ice this program was built with; empty where it was built without.
std::string IceVersion();

/// How a program talks to others, from its command line.
struct NetworkOptions {
  std::string middleware = MiddlewareNames().front();
  std::string certificate;  ///< a file; empty: no TLS
  std::string authority;    ///< the CA's folder; empty: that of this user
  bool insecure = false;

  bool operator==(const NetworkOptions&) const = default;
};

/// Where the CA is that says whom to trust.
std::filesystem::path AuthorityOf(const NetworkOptions& options);

/// --middleware, --certificate, --ca and --insecure. What `options` says already comes before what
/// the environment says.
void AddNetworkOptions(CLI::App& app, NetworkOptions& options);

/// --gcm, an address; `more` is said of it in help, behind the default. Where it is not given,
/// `gcm` stays as it is.
CLI::Option* AddGcmOption(CLI::App& app, std::string& gcm, const std::string& more = "");

/// kInvalid names the middlewares there are. Of a certificate, the errors of CheckCertificate().
tendon::Result<std::shared_ptr<tendon::Middleware>> MakeMiddleware(const NetworkOptions& options);

/// Where the GCM is: `option` if it is not empty, else $TENDON_GCM, else this machine. A host alone
/// means the port where a GCM usually is.
std::string GcmAddress(const std::string& option);

/// kInvalid where it is one word, and the options let nobody be asked but this machine: most likely
/// it was meant as something else.
tendon::Result<void> CheckGcmAddress(const std::string& address, const NetworkOptions& options);

/// kInvalid where what `option` gives is the very address at which the GCM is, or is to be:
/// "--listen and --gcm are both 127.0.0.1:10705, ...". Addresses that are none are judged
/// elsewhere.
tendon::Result<void> CheckOwnPort(const std::string& option, const std::string& address,
                                  const std::string& gcm);

}  // namespace program
