#include <tendon/base/os/process.h>

#include <pwd.h>
#include <sys/random.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <random>

namespace tendon::os {
namespace {

namespace fs = std::filesystem;

fs::path MadeFolder(const fs::path& folder) {
  std::error_code ignored;
  fs::create_directories(folder, ignored);
  fs::permissions(folder, fs::perms::owner_all, ignored);
  return folder;
}

/// Returns $NAME/tendon, or `fallback` if the variable is not set.
fs::path FolderFromEnvironment(const char* name, const fs::path& fallback) {
  const char* base = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): read only
  return base != nullptr && *base != '\0' ? fs::path(base) / "tendon" : fallback;
}

}  // namespace

std::int64_t ProcessId() noexcept { return getpid(); }

Usage OwnUsage() {
  Usage usage;
  timespec used{};
  if (clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used) == 0) {
    usage.cpu_time = std::chrono::seconds(used.tv_sec) + std::chrono::nanoseconds(used.tv_nsec);
  }
  std::uint64_t size = 0;
  std::uint64_t resident = 0;
  std::ifstream pages("/proc/self/statm");
  if (pages >> size >> resident) {
    usage.memory = resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  }
  return usage;
}

bool RunsAsRoot() noexcept { return geteuid() == 0; }

std::string HostName() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) return "localhost";
  return name.data();
}

std::string UserAtHost() {
  const uid_t user = geteuid();
  std::array<char, 4096> room{};
  passwd entry{};
  passwd* found = nullptr;
  const bool has_name =
      getpwuid_r(user, &entry, room.data(), room.size(), &found) == 0 && found != nullptr;
  return (has_name ? std::string(entry.pw_name) : std::to_string(user)) + '@' + HostName();
}

std::uint64_t RandomNumber() {
  std::uint64_t number = 0;
  if (getrandom(&number, sizeof(number), 0) != sizeof(number)) {
    std::random_device device;
    number = (std::uint64_t{device()} << 32U) | device();
  }
  return number;
}

fs::path RuntimeFolder() {
  std::error_code ignored;
  const fs::path fallback =
      fs::temp_directory_path(ignored) / ("tendon-" + std::to_string(getuid()));
  return MadeFolder(FolderFromEnvironment("XDG_RUNTIME_DIR", fallback));
}

fs::path StateFolder() {
  const char* home = std::getenv("HOME");  // NOLINT(concurrency-mt-unsafe): read only
  const fs::path fallback =
      fs::path(home != nullptr ? home : "/tmp") / ".local" / "state" / "tendon";
  return MadeFolder(FolderFromEnvironment("XDG_STATE_HOME", fallback));
}

fs::path ProgramFolder() {
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored).parent_path();
}

void BecomeProgram(const std::vector<std::string>& words, std::size_t most_memory) {
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  setenv("MALLOC_ARENA_MAX", "4", 0);  // each arena reserves address space that it may never use
  rlimit before{};
  const bool is_known = getrlimit(RLIMIT_AS, &before) == 0;
  rlimit limit = before;
  limit.rlim_cur = std::min<rlim_t>(before.rlim_cur, most_memory);
  if (is_known) setrlimit(RLIMIT_AS, &limit);  // after this line, allocations may fail
  execvp(arguments.front(), arguments.data());
  if (is_known) setrlimit(RLIMIT_AS, &before);
}

}  // namespace tendon::os
