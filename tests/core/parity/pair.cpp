#include "core/parity/pair.h"

namespace tendon_test {
namespace {

using namespace std::chrono_literals;

/// Through which the test has jobs executed.
class Director final : public tendon::Component {
 public:
  explicit Director(std::string name) : Component(std::move(name)) {
    AddRequiredInterface("Server").AddFunction(step_server, "Step");
    AddRequiredInterface("Client").AddFunction(step_client, "Step");
  }
  tendon::VoidFunction step_server;
  tendon::VoidFunction step_client;
};

Director& AddDirector(tendon::LocalManager& manager) {
  auto& director = manager.Add<Director>("director");
  EXPECT_TRUE(manager.Connect({"director", "Server"}, {"server", "Desk"}).ok());
  EXPECT_TRUE(manager.Connect({"director", "Client"}, {"client", "Desk"}).ok());
  return director;
}

std::jthread Lend(Part& part) {
  return std::jthread([&part](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      part.Drive();
      std::this_thread::sleep_for(100us);  // as a device that calls back does
    }
  });
}

bool NeedsAThread(Kind kind) { return kind == Kind::kCallback || kind == Kind::kMain; }

}  // namespace

Pair::Pair(Kind client_kind, Kind server_kind)
    : server(AddServer(manager, server_kind)),
      client(AddClient(manager, client_kind)),
      has_thread_(server_kind != Kind::kThreadless),
      step_server_(AddDirector(manager).step_server),
      step_client_(dynamic_cast<Director&>(*manager.Find("director")).step_client) {
  Connect();
  const auto connected = manager.Connect({"client", "Messages"}, {"server", "Messages"});
  EXPECT_TRUE(connected.ok()) << connected.error().message;
  const auto started = manager.StartAll();
  EXPECT_TRUE(started.ok()) << started.error().message;
  if (NeedsAThread(client_kind)) lent_[&client] = Lend(client);
  if (NeedsAThread(server_kind)) lent_[&server] = Lend(server);
}

Pair::~Pair() {
  Release();
  EXPECT_TRUE(manager.StopAll().ok());
}

void Pair::Connect() {
  for (const char* const port : kPortNames) {
    const auto connected = manager.Connect({"client", port}, {"server", port});
    EXPECT_TRUE(connected.ok()) << connected.error().message;
  }
}

bool Pair::Disconnect() {
  const auto begin = std::chrono::steady_clock::now();
  for (const char* const port : kPortNames) {
    EXPECT_TRUE(manager.Disconnect({"client", port}).ok());
  }
  return std::chrono::steady_clock::now() - begin < tendon::LocalManager::kDrainPatience;
}

void Pair::Remove(Part& part) {
  const std::string name = part.component().name();
  if (const auto lent = lent_.find(&part); lent != lent_.end()) {
    EXPECT_TRUE(manager.Stop(name).ok());
    lent_.erase(lent);
  }
  const auto removed = manager.Remove(name);
  EXPECT_TRUE(removed.ok()) << removed.error().message;
}

void Pair::Execute(tendon::VoidFunction& step, Part& part, const std::function<void()>& job) {
  // A component looks into its mailboxes one after the other: what was queued before this call has
  // been executed when it has looked into that of the director twice.
  part.job = [] {};
  EXPECT_EQ(step.Wait(kLong), tendon::Status::kDone);
  part.job = job;
  EXPECT_EQ(step.Wait(kLong), tendon::Status::kDone);
}

void Pair::Hold(tendon::VoidFunction& step, Part& part) {
  std::atomic<bool> is_here = false;
  is_held_ = true;
  part.job = [&] {
    is_here = true;
    while (is_held_) std::this_thread::yield();
  };
  ASSERT_EQ(step(), tendon::Status::kQueued) << "only a task can be held";
  ASSERT_TRUE(EventuallyTrue([&] { return is_here.load(); }));
}

void Pair::Release() {
  is_held_ = false;
  if (manager.Find("server") == nullptr) return;  // removed by the test
  ForEachPort(server.ports, [](auto& port) { port.blocks = false; });
}

}  // namespace tendon_test
