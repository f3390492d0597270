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

/// Returns the names of the middlewares in this build, the default first: "ice" if the program was
/// built with Ice, and "tcp".
std::vector<std::string> MiddlewareNames();

/// The version of Ice in this build; empty without Ice.
std::string IceVersion();

/// The network options of a program's command line.
struct NetworkOptions {
  std::string middleware = MiddlewareNames().front();
  std::string certificate;  ///< a file; empty means no TLS
  std::string authority;    ///< the CA's folder; empty means this user's folder
  bool insecure = false;

  bool operator==(const NetworkOptions&) const = default;
};

/// Returns the folder of the CA with which peers are checked.
std::filesystem::path AuthorityOf(const NetworkOptions& options);

/// Adds --middleware, --certificate, --ca and --insecure. Values already in `options` take
/// precedence over the environment.
void AddNetworkOptions(CLI::App& app, NetworkOptions& options);

/// Adds --gcm, an address. Help shows `more` after the default. If the option is not given, `gcm`
/// stays unchanged.
CLI::Option* AddGcmOption(CLI::App& app, std::string& gcm, const std::string& more = "");

/// Makes the middleware for these options. If the middleware is unknown, the text of kInvalid lists
/// the known ones. If there is a certificate, the errors of CheckCertificate() are possible as
/// well.
tendon::Result<std::shared_ptr<tendon::Middleware>> MakeMiddleware(const NetworkOptions& options);

/// Returns the address of the GCM: `option`; if it is empty, $TENDON_GCM; if this is not set, the
/// address on this machine. A host without a port gets the usual port of a GCM.
std::string GcmAddress(const std::string& option);

/// Returns kInvalid if the address is a single word and the options allow only this machine: the
/// address is then probably a mistake.
tendon::Result<void> CheckGcmAddress(const std::string& address, const NetworkOptions& options);

/// Returns kInvalid if `address`, the value of `option`, is also the address of the GCM: "--listen
/// and --gcm are both 127.0.0.1:10705, ...". Ignores invalid addresses.
tendon::Result<void> CheckOwnPort(const std::string& option, const std::string& address,
                                  const std::string& gcm);

}  // namespace program
