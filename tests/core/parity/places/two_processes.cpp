#include "core/parity/places/two_processes.h"

#include <tendon/gcm/global_manager.h>
#include <tendon/process/process.h>

#include "support/folder.h"
#include "support/network_kinds.h"
#include "support/program.h"

namespace tendon_test {
namespace {

/// Process robot with the server, process desk with the client, and their GCM.
class TwoProcesses final : public Ground {
 public:
  explicit TwoProcesses(const NetworkKind& kind) : join_(kind.make()) {
    auto gcm = tendon::GlobalManager::Start(join_(),
                                            {.address = address_, .state_folder = folder_.path()});
    EXPECT_TRUE(gcm.ok()) << gcm.error().message;
    gcm_ = *std::move(gcm);
    robot_ = Start("robot");
    desk_ = Start("desk");
  }

  tendon::LocalManager& server() override { return *robot_; }
  tendon::LocalManager& client() override { return *desk_; }
  [[nodiscard]] std::string server_process() const override { return "robot"; }

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

}  // namespace

std::vector<PlacedKinds> RemotePairs() {
  std::vector<PlacedKinds> pairs;
  for (const NetworkKind& network : NetworkKinds()) {
    const Place place{.name = "Over" + network.name,
                      .make = [network] { return std::make_unique<TwoProcesses>(network); }};
    for (const Kind kind : AllKinds()) {
      pairs.emplace_back(Kind::kPeriodic, kind, place);
      pairs.emplace_back(Kind::kThreadless, kind, place);
      const bool is_new = kind != Kind::kPeriodic && kind != Kind::kThreadless;
      if (is_new) pairs.emplace_back(kind, Kind::kPeriodic, place);
    }
  }
  return pairs;
}

}  // namespace tendon_test
