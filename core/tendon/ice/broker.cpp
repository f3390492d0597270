#include <tendon/ice/broker.h>

#include <Ice/Ice.h>
#include <openssl/evp.h>
#include <tendon/base/os/shared_library.h>
#include <tendon/base/text.h>
#include <tendon/middleware/hello.h>
#include <tendon/middleware/middleware.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <sstream>

namespace tendon::ice {
namespace {

/// The settings that are the same with and without TLS. If a subscriber does not read, further
/// messages are dropped when its queue is full. A subscriber that reads nothing for 10 s is
/// removed.
constexpr const char* kLimits = R"(
IceBox.InheritProperties=1
IceBox.Service.IceStorm=IceStormService,37:createIceStorm
IceStorm.Transient=1
IceStorm.Send.QueueSizeMax=64
IceStorm.Send.QueueSizeMaxPolicy=DropEvents
IceStorm.Send.Timeout=10000
IceStorm.TopicManager.ThreadPool.Size=1
IceStorm.Publish.ThreadPool.Size=1
Ice.ThreadPool.Client.Size=1
Ice.ThreadPool.Server.Size=1
Ice.MessageSizeMax=320
Ice.Admin.Enabled=0
Ice.RetryIntervals=-1
Ice.ACM.Timeout=1
Ice.ACM.Client.Close=0
Ice.ACM.Client.Heartbeat=3
Ice.ACM.Server.Close=1
Ice.ACM.Server.Heartbeat=0
Ice.Override.ConnectTimeout=3000
)";

std::string SettingsFor(const HostPort& place, const std::string& instance,
                        const std::string& transport) {
  const std::string host = transport + " -h \"" + place.host + "\" -p ";
  return std::string(kLimits) + "IceStorm.InstanceName=" + instance +
         "\nIceBox.PrintServicesReady=broker at " + ToString(place) +
         "\nIceStorm.TopicManager.Endpoints=" + host + std::to_string(place.port) +
         "\nIceStorm.Publish.Endpoints=" + host + "0\n";
}

/// Returns the folders in which the dynamic linker searches libraries for icebox. The folder of Ice
/// comes first.
std::vector<std::filesystem::path> LibraryFolders() {
  const auto* of_ice = reinterpret_cast<const void*>(&Ice::stringToIdentity);
  std::vector<std::filesystem::path> folders = {os::FileOf(of_ice).parent_path()};
  const char* more = std::getenv("LD_LIBRARY_PATH");  // NOLINT(concurrency-mt-unsafe): read only
  std::istringstream rest(more == nullptr ? "" : more);
  for (std::string folder; std::getline(rest, folder, ':');) folders.emplace_back(folder);
  return folders;
}

/// Checks that the settings can contain the file name. Ice reads lines of NAME=VALUE, with comments
/// and escapes, and separates files by ':', so some characters are not possible.
Result<void> CheckFits(const std::filesystem::path& file) {
  const std::string text = file.string();
  if (text.find_first_of("#\\=: \t\r\n") == std::string::npos) return {};
  return Error{ErrorCode::kInvalid,
               "the settings of icebox cannot hold the path " + Quoted(text) +
                   ": put the file into a folder whose path has no '#', '\\', '=', ':' or blank"};
}

}  // namespace

Result<void> CheckBrokerIsInstalled() {
  std::error_code ignored;
  const bool is_there = std::ranges::any_of(LibraryFolders(), [&](const auto& folder) {
    return std::filesystem::exists(folder / "libIceStormService.so.37", ignored);
  });
  if (is_there) return {};
  return Error{ErrorCode::kNotFound,
               "IceStorm is not installed; to install it: apt-get install zeroc-icebox "
               "libzeroc-icestorm3.7 (tools/setup does this, too)"};
}

Result<std::string> BrokerInstance(bool is_certified) {
  if (is_certified) return std::string("tendon");
  const auto cookie = LoopbackCookie();
  if (!cookie) return cookie.error();
  const std::string covered = "broker of " + std::to_string(*cookie);
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  EVP_Digest(covered.data(), covered.size(), digest.data(), nullptr, EVP_sha256(), nullptr);
  std::ostringstream name;
  name << "tendon-" << std::hex << std::setfill('0');
  constexpr std::size_t kBytes = 16;
  for (std::size_t i = 0; i < kBytes; ++i) {
    name << std::setw(2) << static_cast<unsigned>(digest[i]);
  }
  return name.str();
}

Result<std::string> BrokerSettings(const std::string& address) {
  const auto place = ParseAllowedAddress(address, 1, Exposure::kLoopbackOnly);
  if (!place) return place.error();
  const auto instance = BrokerInstance(false);
  if (!instance) return instance.error();
  return SettingsFor(*place, *instance, "tcp");
}

Result<std::string> BrokerSettings(const std::string& address, const Credentials& credentials) {
  const auto place = ParseAllowedAddress(address, 1, Exposure::kCertified);
  if (!place) return place.error();
  const auto certificate = std::filesystem::absolute(credentials.certificate);
  const auto authority = std::filesystem::absolute(credentials.authority);
  auto key = certificate;
  key.replace_extension(".key");
  for (const auto& file : {certificate, authority}) {
    if (auto fits = CheckFits(file); !fits) return fits.error();
  }
  return SettingsFor(*place, *BrokerInstance(true), "ssl") +
         "Ice.Plugin.IceSSL=IceSSL:createIceSSL" +
         "\nIceSSL.Protocols=TLS1_2, TLS1_3\nIceSSL.VerifyPeer=2\nIceSSL.VerifyDepthMax=2" +
         "\nIceSSL.CAs=" + (authority / "ca.crt").string() + "\nIceSSL.RevocationCheck=1" +
         "\nIceSSL.CertificateRevocationListFiles=" + (authority / "crl.pem").string() +
         "\nIceSSL.CertFile=" + certificate.string() + "\nIceSSL.KeyFile=" + key.string() +
         "\nIceSSL.TrustOnly.Server.IceStorm.Publish=OU=operator\n";
}

}  // namespace tendon::ice
