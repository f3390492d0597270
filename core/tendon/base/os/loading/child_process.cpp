#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <tendon/base/os/descriptor.h>
#include <tendon/base/os/loading/child_process.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace tendon::os {
namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr std::size_t kMostOutput = 65536;

/// The child hears every signal, whatever its parent blocks or ignores.
class Attributes {
 public:
  Attributes() {
    sigset_t none;
    sigset_t all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;
  ~Attributes() { posix_spawnattr_destroy(&attributes_); }

  [[nodiscard]] const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

/// Returns 0 or the reason.
int Spawn(const std::string& program, const std::vector<std::string>& arguments, int out,
          pid_t& child) {
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&files, out, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  const Attributes attributes;
  const int reason =
      posix_spawn(&child, program.c_str(), &files, attributes.get(), words.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  return reason;
}

/// Reads until the other end is closed; false when that takes too long.
bool ReadAll(int descriptor, SteadyClock::time_point deadline, std::string& out) {
  std::array<char, 4096> part{};
  while (true) {
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(deadline - SteadyClock::now()).count();
    if (left <= 0) return false;
    pollfd wanted{.fd = descriptor, .events = POLLIN, .revents = 0};
    const int ready = poll(&wanted, 1, static_cast<int>(left));
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
    const ssize_t size = read(descriptor, part.data(), part.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return true;
    if (out.size() < kMostOutput) out.append(part.data(), static_cast<std::size_t>(size));
  }
}

int WaitForEnd(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

Result<ProgramOutcome> RunProgram(const std::filesystem::path& program,
                                  const std::vector<std::string>& arguments,
                                  std::chrono::milliseconds patience) {
  const auto deadline = SteadyClock::now() + patience;
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    return Error{ErrorCode::kFailed, std::string("no pipe: ") + std::strerror(errno)};
  }
  const Descriptor ours(ends[0]);
  Descriptor its(ends[1]);
  pid_t child = 0;
  if (const int reason = Spawn(program.string(), arguments, its.get(), child); reason != 0) {
    return Error{ErrorCode::kFailed, program.string() + " cannot be run: " + std::strerror(reason)};
  }
  its.Close();
  ProgramOutcome outcome;
  const bool ended = ReadAll(ours.get(), deadline, outcome.out);
  if (!ended) kill(child, SIGKILL);
  const int status = WaitForEnd(child);
  if (!ended) {
    return Error{ErrorCode::kTimeout,
                 program.string() + " did not end in " + std::to_string(patience.count()) + " ms"};
  }
  if (WIFEXITED(status)) {
    outcome.exit_code = WEXITSTATUS(status);
  } else {
    const char* name = sigabbrev_np(WTERMSIG(status));
    outcome.signal =
        name != nullptr ? "SIG" + std::string(name) : "signal " + std::to_string(WTERMSIG(status));
  }
  return outcome;
}

}  // namespace tendon::os
