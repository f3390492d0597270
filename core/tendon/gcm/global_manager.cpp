#include <tendon/gcm/global_manager.h>

#include <tendon/base/os/process.h>
#include <tendon/gcm/server/server.h>
#include <tendon/gcm/supervisor/lcm_launcher.h>

#include <algorithm>
#include <future>
#include <utility>

namespace tendon {
namespace {

/// Returns the path of a file or folder of a GCM. The path contains the address, so that GCMs at
/// different addresses do not share files.
std::filesystem::path StatePath(const GlobalManager::Options& options, const std::string& what,
                                const std::string& ending) {
  std::string address = options.address;
  std::replace_if(
      address.begin(), address.end(), [](char letter) { return letter == ':' || letter == '/'; },
      '-');
  const auto folder = options.state_folder.empty() ? os::StateFolder() : options.state_folder;
  return folder / (what + "-" + address + ending);
}

/// Checks that the certificate is for a GCM, because peers refuse a GCM with another certificate.
Result<void> CheckCertificateOf(const Middleware& middleware) {
  const Certificate* certificate = middleware.certificate();
  if (certificate == nullptr) return {};
  if (certificate->name == kGcmName && certificate->holder == Holder::kProcess &&
      certificate->role == Role::kOperator) {
    return {};
  }
  return Error{ErrorCode::kDenied,
               "a GCM needs the certificate of a process '" + std::string(kGcmName) +
                   "' (gcm cert issue " + kGcmName +
                   " --role operator --process); the given certificate belongs to '" +
                   certificate->name + "', a " + std::string(ToString(certificate->holder)) +
                   " and " + std::string(ToString(certificate->role))};
}

}  // namespace

Result<std::unique_ptr<GlobalManager>> GlobalManager::Start(std::shared_ptr<Middleware> middleware,
                                                            Options options) {
  if (auto fits = CheckCertificateOf(*middleware); !fits) return fits.error();
  const auto cookie = LoopbackCookie();
  if (!cookie) return cookie.error();
  const Hello mine{.instance = os::RandomNumber(), .name = kGcmName, .cookie = *cookie};
  // Listens before it makes the server. If another GCM has the address, it also uses the history
  // file, and this function must not open that file.
  std::promise<std::weak_ptr<server::Server>> made;
  const auto choose = [server = made.get_future().share()]() -> std::shared_ptr<ChannelHandler> {
    const auto alive = server.get().lock();
    return alive ? alive->MakeHandler() : nullptr;
  };
  auto listener = middleware->Listen(options.address, Channel::Acceptor(mine, choose));
  if (!listener) return listener.error();
  auto promise = std::move(made);  // moved, so that an exception destroys it before the listener
  auto server = std::make_shared<server::Server>(server::Server::Options{
      .history = StatePath(options, "history", ".jsonl"),
      .clock = options.clock,
      .order_timeout = options.order_timeout,
      .instance = mine.instance,
      .launcher = std::make_shared<server::LcmLauncher>(options.launch, (*listener)->address(),
                                                        StatePath(options, "processes", "")),
      .broker = options.broker});
  server->Start();
  promise.set_value(server);
  return std::unique_ptr<GlobalManager>(new GlobalManager(std::move(middleware), std::move(server),
                                                          *std::move(listener), mine.instance));
}

GlobalManager::GlobalManager(std::shared_ptr<Middleware> middleware,
                             std::shared_ptr<server::Server> server,
                             std::unique_ptr<Listener> listener, std::uint64_t instance)
    : middleware_(std::move(middleware)),
      server_(std::move(server)),
      listener_(std::move(listener)),
      instance_(instance) {}

GlobalManager::~GlobalManager() {
  server_->Stop();
  listener_.reset();
}

Catalogue GlobalManager::catalogue() const { return server_->catalogue(); }

void GlobalManager::Tick() { server_->Tick(); }

}  // namespace tendon
