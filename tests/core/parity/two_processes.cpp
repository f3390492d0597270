#include "core/parity/two_processes.h"

#include <tendon/gcm/global_manager.h>
#include <tendon/process/process.h>

#include <map>
#include <memory>
#include <string>

#include "support/folder.h"
#include "support/network_kinds.h"
#include "support/program.h"

namespace tendon_test {
namespace {

/// The process robot for servers, the process desk for clients, and their GCM.
class TwoProcesses {
 public:
  explicit TwoProcesses(const NetworkKind& kind) : join_(kind.make()) {
    auto gcm = tendon::GlobalManager::Start(join_(),
                                            {.address = address_, .state_folder = folder_.path()});
    EXPECT_TRUE(gcm.ok()) << gcm.error().message;
    gcm_ = *std::move(gcm);
    robot_ = Start("robot");
    desk_ = Start("desk");
  }

  [[nodiscard]] tendon::Process& robot() { return *robot_; }
  [[nodiscard]] tendon::Process& desk() { return *desk_; }

 private:
  [[nodiscard]] std::unique_ptr<tendon::Process> Start(const std::string& name) const {
    auto process = std::make_unique<tendon::Process>(
        name, tendon::ProcessOptions{.middleware = join_(), .gcm = address_});
    const auto joined = process->WaitUntilJoined(kLong);
    EXPECT_TRUE(joined.ok()) << joined.error().message;
    return process;
  }

  const NetworkKind::Join join_;
  const tendon::test::Folder folder_;
  const std::string address_ = "127.0.0.1:" + std::to_string(FreePort());
  std::unique_ptr<tendon::GlobalManager> gcm_;
  std::unique_ptr<tendon::Process> robot_;
  std::unique_ptr<tendon::Process> desk_;
};

/// The processes of every network. They are started when first needed, and all pairs use them one
/// after the other.
class Processes final : public testing::Environment {
 public:
  void TearDown() override { all_.clear(); }

  TwoProcesses& On(const NetworkKind& kind) {
    std::unique_ptr<TwoProcesses>& one = all_[kind.name];
    if (!one) one = std::make_unique<TwoProcesses>(kind);
    return *one;
  }

 private:
  std::map<std::string, std::unique_ptr<TwoProcesses>> all_;
};

Processes& TheProcesses() {
  static auto& processes = static_cast<Processes&>(  // GoogleTest owns this object
      *testing::AddGlobalTestEnvironment(std::make_unique<Processes>().release()));
  return processes;
}

class BetweenProcesses final : public Ground {
 public:
  explicit BetweenProcesses(TwoProcesses& processes) : processes_(processes) {}

  tendon::LocalManager& server() override { return processes_.robot(); }
  tendon::LocalManager& client() override { return processes_.desk(); }
  [[nodiscard]] std::string server_process() const override { return "robot"; }
  void Clear() override {
    RemoveAll(client());
    RemoveAll(server());
  }

 private:
  static void RemoveAll(tendon::LocalManager& manager) {
    for (const auto& component : manager.components()) {
      const auto removed = manager.Remove(component.name);
      EXPECT_TRUE(removed.ok()) << removed.error().message;
    }
  }

  TwoProcesses& processes_;
};

}  // namespace

std::vector<PlacedKinds> RemotePairs() {
  Processes& processes = TheProcesses();
  std::vector<PlacedKinds> pairs;
  for (const NetworkKind& network : NetworkKinds()) {
    const Place place{.name = "Over" + network.name, .make = [network, &processes] {
                        return std::make_unique<BetweenProcesses>(processes.On(network));
                      }};
    for (const Kind client : AllKinds()) {
      for (const Kind server : AllKinds()) pairs.emplace_back(client, server, place);
    }
  }
  return pairs;
}

}  // namespace tendon_test
