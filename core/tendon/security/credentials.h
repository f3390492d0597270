#pragma once

#include <filesystem>

namespace tendon {

/// What a program shows to its peers under TLS, and by what it judges theirs.
struct Credentials {
  std::filesystem::path certificate;  ///< PEM; its private key is beside it, as .key
  std::filesystem::path authority;    ///< the folder of the CA's ca.crt and crl.pem
};

/// The folder of this user's CA, where no other is named.
[[nodiscard]] std::filesystem::path UsualAuthority();

}  // namespace tendon
