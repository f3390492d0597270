#include <gtest/gtest.h>
#include <tendon/base/os/process.h>
#include <tendon/proxy/component_proxy.h>
#include <tendon/task/periodic_task.h>

#include <atomic>
#include <map>
#include <thread>
#include <vector>

#include "core/process/connections/cutting_middleware.h"
#include "support/network_test.h"
#include "support/record.h"

namespace {

using namespace std::chrono_literals;
using tendon::Status;

const tendon::InterfaceName kBooks("robot", "bank", "Books");
const tendon::InterfaceName kClerk("desk", "clerk", "Books");

/// Executes commands, and records them.
class Bank final : public tendon::PeriodicTask {
 public:
  explicit Bank(std::string name) : PeriodicTask(std::move(name), 1ms) {
    auto& books = AddProvidedInterface("Books");
    books.AddCommandWrite(&Bank::Note, this, "Note");
    books.AddCommandWrite(&Bank::Pay, this, "Pay");
    books.AddCommandWriteReturn(&Bank::Double, this, "Double");
  }
  ~Bank() override { Join(); }

  void Run() override { ProcessQueuedCommands(); }

  [[nodiscard]] std::vector<int> log() const { return log_.values(); }
  [[nodiscard]] std::size_t executed() const { return log_.size(); }

 private:
  void Note(int number) { log_.Add(number); }
  void Pay(int number) { Note(number); }
  void Double(const int& number, int& twice) {
    Note(number);
    twice = 2 * number;
  }

  tendon::test::Record<int> log_;
};

/// A component without a thread: the tests call its functions in any thread.
class Clerk final : public tendon::Component {
 public:
  explicit Clerk(std::string name) : Component(std::move(name)) {
    auto& books = AddRequiredInterface("Books");
    books.AddFunction(note, "Note");
    books.AddFunction(pay, "Pay");
    books.AddFunction(twice, "Double");
  }

  tendon::WriteFunction<int> note;
  tendon::WriteFunction<int> pay;
  tendon::WriteReturnFunction<int, int> twice;
};

/// The calls of one caller and their outcomes, in order.
struct History {
  struct Call {
    int number = 0;
    Status status = Status::kDone;
    bool answer_is_right = true;
  };
  std::vector<Call> calls;
};

/// Checks the outcomes against the executions. A call that was reported as done must be executed
/// once. A refused call must not be executed. Any other call must be executed at most once.
void Check(const History& history, const std::map<int, int>& executions) {
  for (const auto& [number, status, answer_is_right] : history.calls) {
    const auto found = executions.find(number);
    const int times = found == executions.end() ? 0 : found->second;
    switch (status.code()) {
      case Status::kDone:
        ASSERT_EQ(times, 1) << number;
        ASSERT_TRUE(answer_is_right) << number;
        break;
      case Status::kOutcomeUnknown:
      case Status::kQueued:
        ASSERT_LE(times, 1) << number;
        break;
      default:
        ASSERT_EQ(times, 0) << number << ": " << ToString(status);
    }
  }
}

/// Calls continue while the link between the two processes is cut repeatedly.
class CutLink : public NetworkTest {
 protected:
  CutLink() {
    robot = Start("robot");
    bank = &robot->Add<Bank>("bank");
    EXPECT_TRUE(robot->StartAll().ok());
    tendon::ProcessOptions options = Options();
    middleware = std::make_shared<CuttingMiddleware>(options.middleware, options.gcm);
    options.middleware = middleware;
    desk = std::make_unique<tendon::Process>("desk", options);
    EXPECT_TRUE(desk->WaitUntilJoined(20s).ok());
    clerk = &desk->Add<Clerk>("clerk");
    EXPECT_TRUE(desk->StartAll().ok());
    const auto id = desk->Connect(kClerk, kBooks);
    EXPECT_TRUE(id.ok()) << id.error().message;
    EXPECT_TRUE(EventuallyActive(*desk, 1));
  }

  [[nodiscard]] bool IsActive() const {
    return desk->connections().front().state == tendon::ConnectionState::kActive;
  }
  /// Repeats `call` with numbers from `first` on until the test ends. After a refusal, waits until
  /// the connection works again.
  template <typename MakeCall>
  void CallAgainAndAgain(int first, MakeCall call, History& history) {
    for (int number = first; !is_done; ++number) {
      history.calls.push_back({.number = number});
      call(history.calls.back());
      if (history.calls.back().status) continue;
      EventuallyTrue([this] { return is_done || IsActive(); });
    }
  }
  void CutAtRandomMoments(int times) {
    for (int i = 0; i < times; ++i) {
      const std::size_t calls = bank->executed() + 1 + tendon::os::RandomNumber() % 200;
      ASSERT_TRUE(EventuallyTrue([&] { return bank->executed() >= calls; }));
      middleware->Cut();
    }
    const std::size_t last = bank->executed() + 100;
    ASSERT_TRUE(EventuallyTrue([&] { return bank->executed() >= last; }));
  }
  /// Waits until all calls from before the cuts, and the last calls, are executed or dropped.
  void LetEverythingEnd() {
    EXPECT_TRUE(EventuallyTrue([this] { return IsActive() && ServedConnections() == 1; }));
    EXPECT_TRUE(
        EventuallyTrue([this] { return clerk->pay.Wait(0, 20s) == Status(Status::kDone); }));
  }
  [[nodiscard]] std::size_t ServedConnections() const {
    std::size_t count = 0;
    for (const auto& proxy : robot->proxies()) count += proxy.required.size();
    return count;
  }
  [[nodiscard]] std::map<int, int> Executions() const {
    std::map<int, int> executions;
    for (const int number : bank->log()) ++executions[number];
    return executions;
  }

  std::unique_ptr<tendon::Process> robot;
  std::unique_ptr<tendon::Process> desk;
  std::shared_ptr<CuttingMiddleware> middleware;
  Bank* bank = nullptr;
  Clerk* clerk = nullptr;
  std::atomic<bool> is_done{false};
};

TEST_P(CutLink, ReportsTheTrueOutcomeOfEachCall) {
  constexpr int kApart = 100'000'000;
  std::vector<History> histories(3);
  std::vector<std::jthread> callers;
  callers.emplace_back([&] {
    CallAgainAndAgain(
        kApart, [&](auto& call) { call.status = clerk->pay.Wait(call.number, 20s); }, histories[0]);
  });
  callers.emplace_back([&] {
    CallAgainAndAgain(
        2 * kApart,
        [&](auto& call) {
          int twice = 0;
          call.status = clerk->twice.Wait(call.number, twice, 20s);
          call.answer_is_right = twice == 2 * call.number;
        },
        histories[1]);
  });
  callers.emplace_back([&] {
    CallAgainAndAgain(
        3 * kApart, [&](auto& call) { call.status = clerk->note(call.number); }, histories[2]);
  });

  CutAtRandomMoments(8);
  is_done = true;
  callers.clear();
  LetEverythingEnd();

  const auto executions = Executions();
  for (const History& history : histories) Check(history, executions);
}

INSTANTIATE_TEST_SUITE_P(Over, CutLink, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
