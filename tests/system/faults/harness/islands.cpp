#include "system/faults/harness/islands.h"

#include <filesystem>
#include <stdexcept>

#include "system/faults/harness/size.h"

namespace faults {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMacHere = "02:00:00:00:77:01";
constexpr const char* kMacThere = "02:00:00:00:77:02";
constexpr const char* kMacOfNobody = "02:00:00:00:77:99";

/// Whether the process has a namespace of its own by now.
bool IsApart(const Program& program, const std::string& kind, const std::string& other) {
  std::error_code ignored;
  const auto of = [&](const std::string& process) {
    return fs::read_symlink("/proc/" + process + "/ns/" + kind, ignored);
  };
  const auto its = of(std::to_string(program.pid()));
  return !its.empty() && its != of(other);
}

/// Does nothing but keep a namespace alive.
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
  const bool is_here = Eventually(
      [&] { return here_->Wait(std::chrono::seconds(0)) || IsApart(*here_, "net", "self"); });
  if (!is_here || here_->Wait(std::chrono::seconds(0))) {
    reason_ = "no user namespace: " + here_->err();
    return;
  }
  Program::Words words = In(*here_);
  for (const std::string& word : Keeper("-n")) words.push_back(word);
  there_ = std::make_unique<Program>(words);
  const std::string first = std::to_string(here_->pid());
  Eventually([&] {
    return there_->Wait(std::chrono::seconds(0)) ||
           (IsApart(*there_, "net", first) && IsApart(*there_, "net", "self"));
  });
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

/// What is sent to `peer` goes to the card of that address.
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
