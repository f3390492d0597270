#pragma once

#include <filesystem>

namespace tendon {

/// The TLS files of a program: its own certificate, and the CA to check peers.
struct Credentials {
  std::filesystem::path certificate;  ///< PEM; the private key is beside it, as .key
  std::filesystem::path authority;    ///< the folder of the CA's ca.crt and crl.pem
};

}  // namespace tendon
