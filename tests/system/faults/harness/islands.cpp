#include "system/faults/harness/islands.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "system/faults/harness/size.h"

namespace faults {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMacHere = "02:00:00:00:77:01";
constexpr const char* kMacThere = "02:00:00:00:77:02";
constexpr const char* kMacOfNobody = "02:00:00:00:77:99";

/// Returns true when the keeper has its namespaces and its user is mapped there; then it runs
/// sleep. A program that enters the namespace earlier would lose its rights.
bool IsReady(const Program& keeper) {
  std::ifstream file("/proc/" + std::to_string(keeper.pid()) + "/comm");
  std::string name;
  return std::getline(file, name) && name == "sleep";
}

/// Waits until the keeper is ready. Returns false if the keeper has ended.
bool EventuallyReady(Program& keeper) {
  const auto has_ended = [&] { return keeper.Wait(std::chrono::seconds(0)).has_value(); };
  return Eventually([&] { return IsReady(keeper) || has_ended(); }) && !has_ended();
}

/// Returns a command that only keeps a namespace alive.
Program::Words Keeper(const std::string& flags) {
  return {"/usr/bin/unshare", flags, "/bin/sleep", "600"};
}

Program::Words In(const Program& keeper) {
  return {"/usr/bin/nsenter",          "--preserve-credentials", "-U", "-n", "-t",
          std::to_string(keeper.pid())};
}

}  // namespace

Islands::Islands() { Begin(); }

void Islands::Begin() {
  for (const char* tool : {"/usr/bin/unshare", "/usr/bin/nsenter"}) {
    if (!fs::exists(tool)) reason_ = std::string("there is no ") + tool;
  }
  if (!ok()) return;
  here_ = std::make_unique<Program>(Keeper("-Urn"));
  if (!EventuallyReady(*here_)) {
    reason_ = "no user namespace: " + here_->err();
    return;
  }
  Program::Words words = In(*here_);
  for (const std::string& word : Keeper("-n")) words.push_back(word);
  there_ = std::make_unique<Program>(words);
  if (!EventuallyReady(*there_)) {
    reason_ = "no second namespace: " + there_->err();
    return;
  }
  const Outcome cable =
      Do(Here(), std::string("PATH=$PATH:/usr/sbin:/sbin; ip link add v0 address ") + kMacHere +
                     " type veth peer name v1 address " + kMacThere + " netns " +
                     std::to_string(there_->pid()) + " && ip link set lo up && ip addr add " +
                     kHere + "/24 dev v0 && ip link set v0 up");
  const Outcome end = Do(There(), std::string("PATH=$PATH:/usr/sbin:/sbin; ip link set lo up && ") +
                                      "ip addr add " + kThere + "/24 dev v1 && ip link set v1 up");
  if (cable.exit_code != 0 || end.exit_code != 0) reason_ = "no cable: " + cable.err + end.err;
  if (ok()) Heal();
}

Program::Words Islands::Here() const { return In(*here_); }
Program::Words Islands::There() const { return In(*there_); }

Outcome Islands::Do(Program::Words island, const std::string& script) {
  for (const std::string& word : {std::string("/bin/sh"), std::string("-c"), script}) {
    island.push_back(word);
  }
  return RunProgram(island);
}

/// Sends data for `peer` to the network card with this address.
void Islands::Aim(const Program::Words& island, const std::string& peer, const std::string& device,
                  const std::string& address) const {
  const Outcome done = Do(island, "PATH=$PATH:/usr/sbin:/sbin; ip neigh replace " + peer +
                                      " lladdr " + address + " dev " + device + " nud permanent");
  if (done.exit_code != 0) throw std::runtime_error("no cut: " + done.err);
}

void Islands::Make(Cut cut) const {
  if (cut != Cut::kFromThere) Aim(Here(), kThere, "v0", kMacOfNobody);
  if (cut != Cut::kFromHere) Aim(There(), kHere, "v1", kMacOfNobody);
}

void Islands::Heal() const {
  Aim(Here(), kThere, "v0", kMacThere);
  Aim(There(), kHere, "v1", kMacHere);
}

}  // namespace faults
