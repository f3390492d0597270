#include <tendon/base/os/child_process.h>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <tendon/base/os/file.h>
#include <tendon/base/text.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

namespace tendon::os {
namespace {

using WaitClock = std::chrono::steady_clock;

constexpr std::size_t kMaxOutput = 65536;

/// The attributes of a new child process. The child receives every signal, even those that its
/// parent blocks or ignores.
class Attributes {
 public:
  explicit Attributes(int further_flags = 0) {
    sigset_t none;
    sigset_t all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    const int flags = POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | further_flags;
    posix_spawnattr_setflags(&attributes_, static_cast<short>(flags));
  }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;
  ~Attributes() { posix_spawnattr_destroy(&attributes_); }

  [[nodiscard]] const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

/// Returns the command line in the form of posix_spawn(). It points into the two arguments and must
/// not outlive them.
std::vector<char*> CommandLine(const std::string& program,
                               const std::vector<std::string>& arguments) {
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  return words;
}

/// Converts the status from waitpid() to an outcome without output.
ProgramOutcome OutcomeOf(int status) {
  ProgramOutcome outcome;
  if (WIFEXITED(status)) {
    outcome.exit_code = WEXITSTATUS(status);
  } else {
    const char* name = sigabbrev_np(WTERMSIG(status));
    outcome.signal =
        name != nullptr ? "SIG" + std::string(name) : "signal " + std::to_string(WTERMSIG(status));
  }
  return outcome;
}

/// Starts a child process whose output goes to `out`. Returns 0 or the error number.
int Spawn(const std::string& program, const std::vector<std::string>& arguments, int out,
          pid_t& child) {
  const std::vector<char*> words = CommandLine(program, arguments);
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

/// Reads until the child has closed its end of the pipe. Returns false if the deadline passes
/// first.
bool ReadAll(int descriptor, WaitClock::time_point deadline, std::string& out) {
  std::array<char, 4096> part{};
  while (true) {
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(deadline - WaitClock::now()).count();
    if (left <= 0) return false;
    pollfd wanted{.fd = descriptor, .events = POLLIN, .revents = 0};
    const int ready = poll(&wanted, 1, static_cast<int>(left));
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
    const ssize_t size = read(descriptor, part.data(), part.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return true;
    if (out.size() < kMaxOutput) out.append(part.data(), static_cast<std::size_t>(size));
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
                                  std::chrono::milliseconds timeout) {
  const auto deadline = WaitClock::now() + timeout;
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    return Error{ErrorCode::kFailed, std::string("cannot create a pipe: ") + std::strerror(errno)};
  }
  const Descriptor ours(ends[0]);
  Descriptor its(ends[1]);
  pid_t child = 0;
  if (const int reason = Spawn(program.string(), arguments, its.get(), child); reason != 0) {
    return Error{ErrorCode::kFailed, program.string() + " cannot be run: " + std::strerror(reason)};
  }
  its.Close();
  std::string out;
  const bool ended = ReadAll(ours.get(), deadline, out);
  if (!ended) kill(child, SIGKILL);
  const int status = WaitForEnd(child);
  if (!ended) {
    return Error{ErrorCode::kTimeout,
                 program.string() + " did not end in " + Milliseconds(timeout)};
  }
  ProgramOutcome outcome = OutcomeOf(status);
  outcome.out = std::move(out);
  return outcome;
}

Result<std::unique_ptr<BackgroundProgram>> BackgroundProgram::Start(
    const std::filesystem::path& program, const std::vector<std::string>& arguments,
    const std::filesystem::path& log) {
  constexpr int kNewFile = O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_NOFOLLOW;
  constexpr mode_t kOurs = 0600;
  const std::string path = program.string();
  const std::vector<char*> words = CommandLine(path, arguments);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), kNewFile, kOurs);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
  const Attributes attributes(POSIX_SPAWN_SETSID);
  pid_t child = 0;
  const int reason =
      posix_spawn(&child, path.c_str(), &files, attributes.get(), words.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (reason != 0) {
    return Error{ErrorCode::kFailed, path + " could not be started with the log file " +
                                         log.string() + ": " + std::strerror(reason)};
  }
  return std::unique_ptr<BackgroundProgram>(new BackgroundProgram(child));
}

std::optional<ProgramOutcome> BackgroundProgram::Ended() {
  if (end_) return end_;
  int status = 0;
  const pid_t ended = waitpid(static_cast<pid_t>(pid_), &status, WNOHANG);
  if (ended == pid_) end_ = OutcomeOf(status);
  if (ended < 0 && errno == ECHILD) end_ = ProgramOutcome{{}, {}, "an unknown cause"};
  return end_;
}

void BackgroundProgram::Terminate() { Signal(SIGTERM); }

void BackgroundProgram::Kill() { Signal(SIGKILL); }

/// Sends a signal to the child. The signal cannot reach another process, because the kernel reuses
/// the child's process number only after waitpid() has reported the child's end.
void BackgroundProgram::Signal(int signal) {
  if (!end_) kill(static_cast<pid_t>(pid_), signal);
}

}  // namespace tendon::os
