#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <tendon/base/log.h>
#include <tendon/base/os/futex.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <string_view>

namespace tendon {
namespace {

constexpr int kCannotBeRefused = 77;

/// Makes membarrier fail in this thread from now on. Returns false if this is not possible.
bool RefuseMembarrier() {
  std::array<sock_filter, 4> steps{
      sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_membarrier, 0, 1),
      sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM),
      sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
  const sock_fprog program{steps.size(), steps.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

/// Returns the number of warnings of three barriers, in a child process.
int WarningsWhereTheKernelRefuses() {
  const pid_t child = fork();
  if (child == 0) {
    static int warnings = 0;
    AddLogSink([](LogLevel level, std::string_view /*source*/, std::string_view message) {
      const bool is_it = message.starts_with("the kernel refuses membarrier, ");
      if (level == LogLevel::kWarning && is_it) ++warnings;
    });
    if (!RefuseMembarrier()) _exit(kCannotBeRefused);
    for (int i = 0; i < 3; ++i) os::ProcessBarrier();
    _exit(warnings);
  }
  int status = -1;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(ProcessBarrier, WarnsOnceIfTheKernelRefusesIt) {
  const int warnings = WarningsWhereTheKernelRefuses();
  if (warnings == kCannotBeRefused) GTEST_SKIP() << "system calls cannot be filtered here";

  EXPECT_EQ(warnings, 1);
}

}  // namespace
}  // namespace tendon
