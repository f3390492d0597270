#pragma once

#include <filesystem>

namespace tendon {

/// The TLS files of a program: its own certificate, and the CA with which it checks peers.
struct Credentials {
  /// PEM; the private key is in the same folder, with the extension .key.
  std::filesystem::path certificate;
  std::filesystem::path authority;  ///< the folder with ca.crt and crl.pem of the CA
};

}  // namespace tendon
