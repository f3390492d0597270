#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/base/os/process.h>
#include <tendon/gcm/supervisor/supervisor.h>
#include <tendon/middleware/channel.h>
#include <tests/core/gcm/samples.h>
#include <tests/support/folder.h>
#include <tests/support/wait.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace tendon::server {

using namespace std::
    chrono_literals;  // NOLINT(google-build-using-namespace,google-global-names-in-headers)

/// A fake process that ends when the test requests it. Its functions are called while the
/// launcher's owner holds its lock.
class FakeProcessOfGcm final : public StartedProcess {
 public:
  explicit FakeProcessOfGcm(std::int64_t pid) : pid_(pid) {}

  [[nodiscard]] std::int64_t pid() const override { return pid_; }
  std::optional<ProcessEnd> Ended() override { return end; }
  void Terminate() override { terminated = true; }
  void Kill() override { killed = true; }

  std::optional<ProcessEnd> end;
  bool terminated = false;
  bool killed = false;

 private:
  const std::int64_t pid_;
};

class FakeLauncher final : public Launcher {
 public:
  Result<std::shared_ptr<StartedProcess>> Start(const Order& order) override {
    const std::scoped_lock lock(mutex_);
    orders_.push_back(order);
    if (!refusal.empty()) return Error{ErrorCode::kFailed, refusal};
    processes_.push_back(std::make_shared<FakeProcessOfGcm>(orders_.size()));
    return std::shared_ptr<StartedProcess>(processes_.back());
  }
  ProcessLog LogOf(const std::string& process) override { return {"alas", process + ".log"}; }
  void ShortenLog(const std::string& process) override {
    const std::scoped_lock lock(mutex_);
    shortened_.push_back(process);
  }

  [[nodiscard]] std::size_t starts() const {
    const std::scoped_lock lock(mutex_);
    return orders_.size();
  }
  /// Returns the order for the process that was started last.
  [[nodiscard]] Order order() const {
    const std::scoped_lock lock(mutex_);
    return orders_.back();
  }
  [[nodiscard]] std::shared_ptr<FakeProcessOfGcm> process() const {
    const std::scoped_lock lock(mutex_);
    return processes_.back();
  }

  /// Returns the names of the processes whose logs were shortened.
  [[nodiscard]] std::vector<std::string> shortened() const {
    const std::scoped_lock lock(mutex_);
    return shortened_;
  }

  std::string refusal;

 private:
  mutable std::mutex mutex_;
  std::vector<Order> orders_;
  std::vector<std::string> shortened_;
  std::vector<std::shared_ptr<FakeProcessOfGcm>> processes_;
};

/// The part of a GCM that starts processes. The test acts as these processes.
class SupervisorTest : public testing::Test {
 protected:
  /// The outcome of an order.
  struct Answer {
    std::atomic<bool> is_here = false;
    std::string text;  ///< empty if the order succeeded
  };
  using SharedAnswer = std::shared_ptr<Answer>;

  template <typename Action>
  void Locked(Action&& action) {
    {
      const std::scoped_lock lock(mutex_);
      action();
    }
    deferred_.Flush();
  }

  SharedAnswer Order(ProcessVerb verb, RestartPolicy restart = RestartPolicy::kOnFailure) {
    const auto answer = std::make_shared<Answer>();
    const message::ProcessOrder order{
        .verb = verb, .process = "robot", .restart = restart, .timeout = 5s};
    Locked([&] {
      supervisor_.ExecuteOrder(order, "test", [answer](const Result<None>& result) {
        answer->text = result ? "" : result.error().message;
        answer->is_here = true;
      });
    });
    return answer;
  }
  void Tick() {
    Locked([this] { supervisor_.Tick(); });
  }
  template <typename Predicate>
  testing::AssertionResult Comes(Predicate predicate) {
    const bool came = EventuallyTrue([&] {
      Tick();
      const std::scoped_lock lock(mutex_);
      return predicate();
    });
    return came ? testing::AssertionSuccess() : testing::AssertionFailure() << Reason();
  }
  testing::AssertionResult IsAnswered(const SharedAnswer& answer) {
    return Comes([&] { return answer->is_here.load(); });
  }
  /// Returns the reply to an order that needs no process.
  static std::string TextOf(const SharedAnswer& answer) {
    EXPECT_TRUE(EventuallyTrue([&] { return answer->is_here.load(); }));
    return answer->text;
  }
  /// Joins the GCM as the started process.
  void Join(std::vector<ComponentDescription> components = {}) {
    Locked([&] {
      const auto admission = registry_.Join({{.name = "robot",
                                              .instance = launcher_->starts(),
                                              .host = os::HostName(),
                                              .pid = launcher_->process()->pid()},
                                             std::move(components),
                                             {}},
                                            0, nullptr);
      ASSERT_TRUE(admission) << admission.error().message;
      session_ = admission->session;
    });
  }
  /// Starts the process, and joins the GCM as this process.
  void Run(RestartPolicy restart, std::vector<ComponentDescription> components = {}) {
    const auto answer = Order(ProcessVerb::kStart, restart);
    ASSERT_TRUE(Comes([this] { return launcher_->starts() == 1; }));
    Join(std::move(components));
    ASSERT_TRUE(IsAnswered(answer));
    ASSERT_EQ(answer->text, "");
  }
  void End(const ProcessEnd& end, ProcessState state = ProcessState::kLost) {
    Locked([&] {
      launcher_->process()->end = end;
      registry_.End(session_, state, "its connection broke");
    });
  }
  /// Makes the process fail, be restarted after the pause, and join again.
  void FailOnce(std::chrono::milliseconds pause, std::vector<ComponentDescription> components) {
    const std::size_t before = launcher_->starts();
    End(kKilled);
    ASSERT_TRUE(Comes([&] { return ReasonNow().find("restarted in") != std::string::npos; }));
    clock_.Advance(pause);
    ASSERT_TRUE(Comes([&] { return launcher_->starts() == before + 1; }));
    Join(std::move(components));
  }
  [[nodiscard]] std::string ReasonNow() const {
    const auto* const entry = registry_.catalogue().FindProcess("robot");
    return entry == nullptr ? "" : entry->process.reason;
  }
  [[nodiscard]] std::string Reason() {
    const std::scoped_lock lock(mutex_);
    return ReasonNow();
  }

  static inline const ProcessEnd kKilled{true, "was ended by SIGKILL"};

  const test::Folder folder_;
  ManualClock clock_;
  std::mutex mutex_;
  Registry registry_{Leases{}, clock_};
  StepHistory history_{folder_.path() / "history.jsonl"};
  DeferredActions deferred_;
  SessionToken session_ = 0;
  const std::shared_ptr<FakeLauncher> launcher_ = std::make_shared<FakeLauncher>();
  Supervisor supervisor_{{registry_, history_, deferred_, clock_, launcher_},
                         [this](const std::function<void(Supervisor&)>& action) {
                           Locked([&] { action(supervisor_); });
                         }};
};

}  // namespace tendon::server
