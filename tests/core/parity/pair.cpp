#include "core/parity/pair.h"

#include <algorithm>

namespace tendon_test {
namespace {

using namespace std::chrono_literals;

class OneManager final : public Ground {
 public:
  tendon::LocalManager& server() override { return manager_; }
  tendon::LocalManager& client() override { return manager_; }

 private:
  tendon::LocalManager manager_;
};

/// A component through which the test executes its jobs.
class Director final : public tendon::Component {
 public:
  explicit Director(std::string name) : Component(std::move(name)) {
    AddRequiredInterface("Part").AddFunction(step, "Step");
  }
  tendon::VoidFunction step;
};

tendon::VoidFunction& Direct(tendon::LocalManager& manager, const std::string& part) {
  const std::string name = "director-of-" + part;
  auto& director = manager.Add<Director>(name);
  EXPECT_TRUE(manager.Connect({name, "Part"}, {part, "Desk"}).ok());
  return director.step;
}

std::jthread Lend(Part& part) {
  return std::jthread([&part](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      part.Drive();
      std::this_thread::sleep_for(100us);  // like a device that calls back
    }
  });
}

bool NeedsAThread(Kind kind) { return kind == Kind::kCallback || kind == Kind::kMain; }

}  // namespace

Place OneProcess() {
  return {.name = "", .make = [] { return std::make_unique<OneManager>(); }};
}

Pair::Pair(Kind client_kind, Kind server_kind, const Place& place)
    : ground_(place.make()),
      manager(ground_->server()),
      server(AddServer(ground_->server(), server_kind)),
      client(AddClient(ground_->client(), client_kind)),
      has_thread_(server_kind != Kind::kThreadless),
      step_server_(Direct(ground_->server(), "server")),
      step_client_(Direct(ground_->client(), "client")) {
  Connect();
  const auto connected =
      ground_->client().Connect({"client", "Messages"}, ServerInterface("Messages"));
  EXPECT_TRUE(connected.ok()) << connected.error().message;
  for (tendon::LocalManager* one : {&ground_->server(), &ground_->client()}) {
    const auto started = one->StartAll();
    EXPECT_TRUE(started.ok()) << started.error().message;
  }
  if (NeedsAThread(client_kind)) lent_[&client] = Lend(client);
  if (NeedsAThread(server_kind)) lent_[&server] = Lend(server);
  if (is_remote()) AwaitConnections();
}

Pair::~Pair() {
  Release();
  EXPECT_TRUE(ground_->client().StopAll().ok());
  EXPECT_TRUE(ground_->server().StopAll().ok());
  lent_.clear();
  ground_->Clear();
}

void Pair::Connect() {
  for (const char* const port : kPortNames) {
    const auto connected = ground_->client().Connect({"client", port}, ServerInterface(port));
    EXPECT_TRUE(connected.ok()) << connected.error().message;
  }
}

tendon::InterfaceName Pair::ServerInterface(const std::string& name) const {
  return {ground_->server_process(), "server", name};
}

void Pair::AwaitConnections() {
  EXPECT_TRUE(EventuallyTrue([this] {
    return std::ranges::all_of(ground_->client().connections(), [](const auto& one) {
      return one.state == tendon::ConnectionState::kActive;
    });
  }));
  InClient([](auto& port) {  // the client learns a moment later that the server runs
    const auto value = Sample<PayloadIn<decltype(port)>>(0);
    EXPECT_TRUE(EventuallyTrue([&] { return bool(port.write_direct(value)); }));
  });
}

void Pair::Deliver() {
  if (!is_remote()) return;
  InClient([](auto& port) {
    PayloadIn<decltype(port)> value;
    EXPECT_EQ(port.take.Wait(value, kLong), tendon::Status::kDone);
  });
  InServer([](auto& port) { port.settled(Sample<PayloadIn<decltype(port)>>(0)); });
  InClient([](auto& port) {
    PayloadIn<decltype(port)> value;
    EXPECT_EQ(port.settled.Wait(value, kLong), tendon::Status::kDone);
  });
}

void Pair::ExpectInThreadOf(std::thread::id caller, std::thread::id thread) const {
  if (!is_remote()) {
    EXPECT_EQ(thread, caller);
    return;
  }
  EXPECT_NE(thread, std::thread::id());
  EXPECT_NE(thread, caller);
  EXPECT_NE(thread, std::this_thread::get_id());
}

bool Pair::Disconnect() {
  const auto begin = std::chrono::steady_clock::now();
  for (const char* const port : kPortNames) {
    EXPECT_TRUE(ground_->client().Disconnect({"client", port}).ok());
  }
  return std::chrono::steady_clock::now() - begin < tendon::LocalManager::kDrainTimeout;
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
  // A component checks its mailboxes one after the other. When it has checked the mailbox of the
  // director twice, all calls that were queued before this function have been executed.
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
  if (manager.Find("server") == nullptr) return;  // the test has removed it
  ForEachPort(server.ports, [](auto& port) { port.blocks = false; });
}

}  // namespace tendon_test
