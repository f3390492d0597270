#include "support/program.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>

#include "support/folder.h"
#include "support/wait.h"

namespace {

namespace fs = std::filesystem;

std::string Content(const std::string& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void RedirectTo(const std::string& file, int descriptor) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(opened, descriptor);
  close(opened);
}

/// Where all programs of this test keep what they would keep at their user's.
const fs::path& Home() {
  static const tendon::test::Folder home;
  return home.path();
}

/// In a child, which else would run on if `parent` were killed, with its ports, for ever.
void EndWith(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // that was before
}

/// In the child.
[[noreturn]] void Become(const Program::Words& command,
                         const std::map<std::string, std::string>& environment,
                         const std::string& folder, const fs::path& home) {
  RedirectTo(folder + "/out", STDOUT_FILENO);
  RedirectTo(folder + "/err", STDERR_FILENO);
  for (const char* name : {"XDG_RUNTIME_DIR", "XDG_STATE_HOME", "XDG_CACHE_HOME"}) {
    setenv(name, home.c_str(), 1);
  }
  for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execv(words[0], words.data());
  _exit(127);
}

/// Keeps other tests, those of other users too, off the port until this one ends: whoever takes it
/// does so later than us. The name of a socket in no folder leaves nothing behind.
bool IsReserved(int port) {
  const std::string name = "tendon-test-port-" + std::to_string(port);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy(name.begin(), name.end(), address.sun_path + 1);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  const int holder = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (holder < 0) return false;
  const bool is_ours = bind(holder, reinterpret_cast<const sockaddr*>(&address), size) == 0;
  if (!is_ours) close(holder);
  return is_ours;  // the socket stays open
}

bool IsFree(int port) {
  const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const bool is_free =
      bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  close(listener);
  return is_free;
}

}  // namespace

Program::Program(const Words& command, const std::map<std::string, std::string>& environment) {
  std::string folder = (fs::temp_directory_path() / "tendon-program-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) throw std::runtime_error("no folder for " + command[0]);
  folder_ = folder;
  const fs::path& home = Home();
  const pid_t parent = getpid();
  const bool is_main_thread = gettid() == parent;  // others may end, and with them what they forked
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("no process for " + command[0]);
  if (pid_ > 0) return;
  if (is_main_thread) EndWith(parent);
  Become(command, environment, folder_, home);
}

Program::~Program() {
  if (!exit_code_) {
    Signal(SIGKILL);
    Wait();
  }
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void Program::Signal(int signal) const {
  if (!exit_code_) kill(pid_, signal);  // else its pid may be another's by now
}

std::optional<int> Program::Wait(std::chrono::seconds patience) {
  EventuallyTrue(
      [this] {
        int status = 0;
        if (exit_code_ || waitpid(pid_, &status, WNOHANG) != pid_) return exit_code_.has_value();
        exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        return true;
      },
      patience);
  return exit_code_;
}

std::string Program::out() const { return Content(folder_ + "/out"); }
std::string Program::err() const { return Content(folder_ + "/err"); }

Outcome RunProgram(const Program::Words& command,
                   const std::map<std::string, std::string>& environment) {
  Program program(command, environment);
  const auto exit_code = program.Wait();
  return {exit_code.value_or(-1), program.out(), program.err()};
}

int FreePort() {
  constexpr int kTries = 1000;
  std::random_device random;
  std::uniform_int_distribution<int> any(20000, 31999);  // the kernel gives others higher ones
  for (int i = 0; i < kTries; ++i) {
    const int port = any(random);
    if (IsReserved(port) && IsFree(port)) return port;
  }
  throw std::runtime_error("no free port");
}
