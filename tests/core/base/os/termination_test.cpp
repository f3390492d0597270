#include <gtest/gtest.h>
#include <tendon/base/os/termination.h>
#include <unistd.h>

#include <csignal>
#include <thread>

namespace tendon::os {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

constexpr int kWasAsked = 3;

void SignalMyself() { kill(getpid(), SIGTERM); }

TEST(Termination, ABlockedSignalIsReportedAndDoesNotKill) {
  EXPECT_EXIT(
      {
        HoldTerminationSignals();
        SignalMyself();
        _exit(TerminationRequested(60s) ? kWasAsked : 0);
      },
      testing::ExitedWithCode(kWasAsked), "");
}

TEST(Termination, ReportsNoRequestWithoutASignal) {
  EXPECT_EXIT(
      {
        HoldTerminationSignals();
        _exit(TerminationRequested(1ms) ? kWasAsked : 0);
      },
      testing::ExitedWithCode(0), "");
}

TEST(Termination, OnlyAnInterruptCanBeCleared) {
  EXPECT_EXIT(
      {
        HoldTerminationSignals();
        kill(getpid(), SIGINT);
        ForgetInterrupt();
        if (TerminationRequested(1ms)) _exit(0);
        SignalMyself();
        ForgetInterrupt();
        _exit(TerminationRequested(60s) ? kWasAsked : 0);
      },
      testing::ExitedWithCode(kWasAsked), "");
}

TEST(Termination, ASecondSignalKills) {
  EXPECT_EXIT(
      {
        HoldTerminationSignals();
        SignalMyself();
        static_cast<void>(TerminationRequested(60s));
        SignalMyself();
        _exit(0);
      },
      testing::KilledBySignal(SIGTERM), "");
}

TEST(Termination, ASignalKillsWithinAnUnblockScope) {
  EXPECT_EXIT(
      {
        HoldTerminationSignals();
        const TerminationUnblockScope impatient;
        SignalMyself();
        _exit(0);
      },
      testing::KilledBySignal(SIGTERM), "");
}

TEST(Termination, SignalsAreBlockedAgainAfterAnUnblockScope) {
  EXPECT_EXIT(
      {
        HoldTerminationSignals();
        { const TerminationUnblockScope impatient; }
        SignalMyself();
        _exit(TerminationRequested(60s) ? kWasAsked : 0);
      },
      testing::ExitedWithCode(kWasAsked), "");
}

TEST(Termination, AnInterruptionAffectsOnlyItsThread) {
  EXPECT_EXIT(
      {
        const std::jthread window([] {
          HoldTerminationSignals();
          Interruption interruption;
          if (TerminationRequested(1ms)) _exit(0);
          const std::jthread user([&] { interruption.Request(); });
          if (!TerminationRequested(60s)) _exit(0);
          interruption.Request();  // does not end this program
          if (WaitForTermination() != SIGINT || TerminationRequested(1ms)) _exit(0);
          { const TerminationUnblockScope impatient; }
          pthread_kill(pthread_self(), SIGTERM);  // the signal is held again
          _exit(kWasAsked);
        });
      },
      testing::ExitedWithCode(kWasAsked), "");
}

}  // namespace
}  // namespace tendon::os
