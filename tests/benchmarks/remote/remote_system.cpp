#include <benchmarks/remote/remote_system.h>
#include <support/wait.h>
#include <tendon/base/os/process.h>
#include <tendon/ice/ice_middleware.h>

#include <csignal>
#include <cstdlib>
#include <ctime>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace tendon::benchmark {

RemoteSystem::RemoteSystem() {
  for (const auto& [name, value] : environment()) setenv(name.c_str(), value.c_str(), 1);
  const std::string program = os::ProgramFolder() / "report_peer";
  peer_ = std::make_unique<Program>(Program::Words{program}, environment());
  Require(EventuallyTrue([this] { return peer_->out().ends_with('\n'); }),
          "the other process does not start");
  std::istringstream(peer_->out()) >> addresses_.gcm >> addresses_.robot >> addresses_.raw >>
      addresses_.raw_of_one_thread;
  process_ = std::make_unique<Process>("desk", Options());
  desk_ = &process_->Add<Desk>("desk");
  Require(process_->StartAll().ok(), "the desk does not start");
  Require(process_->WaitUntilJoined(kTestTimeout).ok(), "the desk does not join");
  Require(process_->Connect({"desk", "desk", "Robot"}, {"robot", "robot", "Control"}).ok() &&
              EventuallyTrue([this] { return IsConnected(); }),
          "the desk is not connected");
  raw_ = std::make_unique<RawIce>(addresses_.raw);
  raw_of_one_thread_ = std::make_unique<RawIce>(addresses_.raw_of_one_thread);
}

bool RemoteSystem::IsConnected() {
  Message joints{};
  return desk_->move.Wait({}, kTestTimeout) && desk_->get_joints(joints);
}

std::map<std::string, std::string> RemoteSystem::environment() const {
  // Both processes use this folder, because they share a cookie.
  const std::string folder = folder_.path();
  return {{"XDG_RUNTIME_DIR", folder}, {"XDG_STATE_HOME", folder}};
}

RivalClient& RemoteSystem::rival(const std::string& id) {
  if (rivals_.empty()) BeginRivals();
  return *rivals_.at(id);
}

void RemoteSystem::BeginRivals() {
  const std::size_t said = peer_->out().size();
  peer_->Signal(SIGUSR1);
  Require(
      EventuallyTrue([&] { return peer_->out().size() > said && peer_->out().ends_with('\n'); }),
      "the other process does not begin the other middlewares");
  std::istringstream addresses(peer_->out().substr(said));
  for (const Rival& rival : Rivals()) {
    std::string address;
    if (rival.missing.empty() && addresses >> address) rivals_[rival.id] = rival.reach(address);
  }
}

ProcessOptions RemoteSystem::Options() const {
  return {.middleware = MakeIceMiddleware(Exposure::kLoopbackOnly), .gcm = addresses_.gcm};
}

std::string RemoteSystem::NewName() { return "joiner" + std::to_string(++names_); }

double RemoteSystem::ProcessorTime() const {
  clockid_t clock{};
  timespec used{};
  if (clock_getcpuclockid(peer(), &clock) != 0 || clock_gettime(clock, &used) != 0) return 0;
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

Hello NewHello(const std::string& name) {
  const auto cookie = LoopbackCookie();
  Require(cookie.ok(), "this user has no cookie");
  return {.instance = os::RandomNumber(), .name = name, .session = 0, .cookie = *cookie};
}

Subject Between(const TheSystem& system, std::function<double(RemoteSystem&)> run) {
  return {.run = [system, run = std::move(run)] { return run(system()); },
          .elsewhere = [system] { return system().ProcessorTime(); }};
}

void Require(bool done, const char* what) {
  if (!done) throw std::runtime_error(what);
}

/// All measurements run on one processor. The processes of these cases start only when needed,
/// after all other cases, so that they disturb no others.
std::vector<Case> NetworkCases(const Effort& effort) {
  const TheSystem system = [made = std::make_shared<std::unique_ptr<RemoteSystem>>()]() -> auto& {
    if (!*made) *made = std::make_unique<RemoteSystem>();
    return **made;
  };
  std::vector<Case> all;
  for (const auto& make : {RemoteCases, RivalCases, StreamCases, JoiningCases, CatalogueCases,
                           QueryCases, RecordingLoadCases}) {
    for (Case& one : make(effort, system)) all.push_back(std::move(one));
  }
  return all;
}

}  // namespace tendon::benchmark
