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

/// The home folder of all programs of this test.
const fs::path& Home() {
  static const tendon::test::Folder home;
  return home.path();
}

/// Ends a child together with its parent. Otherwise the child would continue, and keep its ports,
/// if `parent` were killed.
void EndWith(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // the parent had already ended
}

/// The data for a child, prepared before fork(). Between fork() and exec(), the child must not
/// lock, because another thread may have held the lock during fork().
class Start {
 public:
  Start(const Program::Words& command, const std::map<std::string, std::string>& environment,
        const std::string& folder, const fs::path& home)
      : words_(command), out_(folder + "/out"), err_(folder + "/err") {
    std::map<std::string, std::string> variables = Variables();
    for (const char* name : {"XDG_RUNTIME_DIR", "XDG_STATE_HOME", "XDG_CACHE_HOME"}) {
      variables[name] = home;
    }
    for (const auto& [name, value] : environment) variables[name] = value;
    for (const auto& [name, value] : variables) texts_.push_back(name + "=" + value);
    argv_ = Pointers(words_);
    envp_ = Pointers(texts_);
  }
  Start(const Start&) = delete;
  Start& operator=(const Start&) = delete;

  /// Runs in the child.
  [[noreturn]] void Become() const {
    RedirectTo(out_, STDOUT_FILENO);
    RedirectTo(err_, STDERR_FILENO);
    execve(argv_[0], argv_.data(), envp_.data());
    _exit(127);
  }

 private:
  static std::map<std::string, std::string> Variables() {
    std::map<std::string, std::string> variables;
    for (char** one = environ; *one != nullptr; ++one) {
      const std::string text = *one;
      const std::size_t equals = text.find('=');
      if (equals != std::string::npos) variables[text.substr(0, equals)] = text.substr(equals + 1);
    }
    return variables;
  }
  static std::vector<char*> Pointers(Program::Words& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
  }

  Program::Words words_;
  Program::Words texts_;
  std::vector<char*> argv_;
  std::vector<char*> envp_;
  std::string out_;
  std::string err_;
};

/// Reserves the port until this process ends; all tests, including those of other users, use this
/// reservation. It is the name of an abstract socket, so it needs no file.
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
  return is_ours;  // the socket stays open on purpose
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
  const Start start(command, environment, folder_, Home());
  const pid_t parent = getpid();
  // Another thread could end before its children, which would end them too early.
  const bool is_main_thread = gettid() == parent;
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("no process for " + command[0]);
  if (pid_ > 0) return;
  if (is_main_thread) EndWith(parent);
  start.Become();
}

Program::~Program() {
  if (!exit_code_) {
    Signal(SIGKILL);
    Wait();
  }
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

/// After SIGSTOP, waits until all threads of the program have stopped.
void Program::Signal(int signal) const {
  if (exit_code_ || kill(pid_, signal) != 0) return;  // after the end, another may have this pid
  if (signal != SIGSTOP) return;
  siginfo_t state;
  waitid(P_PID, static_cast<id_t>(pid_), &state, WSTOPPED | WEXITED | WNOWAIT);
}

std::optional<int> Program::Wait(std::chrono::seconds timeout) {
  EventuallyTrue(
      [this] {
        int status = 0;
        if (exit_code_ || waitpid(pid_, &status, WNOHANG) != pid_) return exit_code_.has_value();
        exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        return true;
      },
      timeout);
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
  std::uniform_int_distribution<int> any(20000,
                                         31999);  // the kernel assigns ports above this range
  for (int i = 0; i < kTries; ++i) {
    const int port = any(random);
    if (IsReserved(port) && IsFree(port)) return port;
  }
  throw std::runtime_error("no free port");
}
