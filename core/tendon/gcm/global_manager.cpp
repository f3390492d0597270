#include <tendon/base/os/process.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/gcm/server/server.h>

#include <algorithm>
#include <future>
#include <utility>

namespace tendon {
namespace {

/// GCMs at different addresses have histories of their own.
std::filesystem::path HistoryFile(const GlobalManager::Options& options) {
  std::string address = options.address;
  std::replace_if(
      address.begin(), address.end(), [](char letter) { return letter == ':' || letter == '/'; },
      '-');
  const auto folder = options.state_folder.empty() ? os::StateFolder() : options.state_folder;
  return folder / ("history-" + address + ".jsonl");
}

}  // namespace

Result<std::unique_ptr<GlobalManager>> GlobalManager::Start(std::shared_ptr<Middleware> middleware,
                                                            Options options) {
  const auto cookie = LoopbackCookie();
  if (!cookie) return cookie.error();
  const Hello mine{.instance = os::RandomNumber(), .name = "gcm", .cookie = *cookie};
  // The address first: the history is another GCM's while that listens there.
  std::promise<std::weak_ptr<server::Server>> made;
  const auto choose = [server = made.get_future().share()]() -> std::shared_ptr<ChannelHandler> {
    const auto alive = server.get().lock();
    return alive ? alive->MakeHandler() : nullptr;
  };
  auto listener = middleware->Listen(options.address, Channel::Acceptor(mine, choose));
  if (!listener) return listener.error();
  auto promise = std::move(made);  // broken, where no server comes of it, before the listener ends
  auto server = std::make_shared<server::Server>(
      server::Server::Options{.history = HistoryFile(options),
                              .clock = options.clock,
                              .order_timeout = options.order_timeout,
                              .instance = mine.instance});
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

Catalog GlobalManager::catalog() const { return server_->catalog(); }

void GlobalManager::Tick() { server_->Tick(); }

}  // namespace tendon
