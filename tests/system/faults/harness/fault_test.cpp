#include "system/faults/harness/fault_test.h"

#include <program/network_options.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "support/machine/sanitized.h"
#include "support/program.h"

namespace faults {
namespace {

namespace fs = std::filesystem;
using tendon::ProcessState;

const tendon::InterfaceName kClient("desk", "client", "Ledger");

/// Returns the JSON of a component. `journals` is the folder for a component that keeps a journal.
std::string ComponentText(const std::string& name, const std::string& class_name,
                          const std::string& journals = {}) {
  const std::string configuration =
      journals.empty() ? "" : R"(, "configuration": {"folder": ")" + journals + R"("})";
  return R"({"name": ")" + name + R"(", "class": ")" + class_name +
         R"(", "library": "fault_instruments")" + configuration + "}";
}

/// In this system, robot has the ledger; desk and mate each have a client of the ledger. Each other
/// process is for one test.
std::string SystemFile(const std::string& folder) {
  const auto process = [&](const std::string& name, const std::string& components) {
    return R"({"name": ")" + name + R"(", "components": [)" + components + "]}";
  };
  const auto connection = [](const std::string& required, const std::string& provided) {
    return R"({"required": ")" + required + R"(", "provided": ")" + provided + R"("})";
  };
  std::string pushers = ComponentText("pusher", "Pusher");
  for (const std::string& edit : Edits()) {
    pushers += ", " + ComponentText(edit, "Pusher" + edit);
  }
  return R"({"version": 1, "name": "faults", "processes": [)" +
         process("robot", ComponentText("ledger", "Ledger", folder)) + ", " +
         process("desk", ComponentText("client", "Client", folder)) + ", " +
         process("mate", ComponentText("client", "Client", folder)) + ", " +
         process("well", ComponentText("fountain", "Fountain")) + ", " +
         process("witness", ComponentText("herald", "Herald")) + ", " +
         process("noisy", ComponentText("raver", "Raver") + ", " + ComponentText("calm", "Calm")) +
         ", " + process("post", ComponentText("receiver", "Receiver", folder)) + ", " +
         process("shop", ComponentText("sender", "Sender")) + ", " +
         process("wrist", ComponentText("sensor", "Sensor")) + ", " + process("hand", pushers) +
         R"(], "connections": [)" + connection("desk/client/Ledger", "robot/ledger/Control") +
         ", " + connection("mate/client/Ledger", "robot/ledger/Control") + ", " +
         connection("shop/sender/Parcels", "post/receiver/Parcels") + "]}";
}

/// Returns true if all components are active, so that nothing more changes by itself.
bool IsActive(const tendon::Catalogue& catalogue) {
  for (const auto& [name, entry] : catalogue.processes()) {
    const auto is_active = [](const auto& one) {
      return one.second.state == tendon::ComponentState::kActive;
    };
    if (!std::ranges::all_of(entry.components, is_active)) return false;
  }
  return true;
}

}  // namespace

const std::vector<std::string>& Edits() {
  static const std::vector<std::string> edits{"InFloats",     "InPounds",     "Renamed",
                                              "WithMore",     "WithLess",     "InOtherOrder",
                                              "OfOtherShape", "InOtherFrames"};
  return edits;
}

bool HasStopped(int pid) {
  const fs::path threads = "/proc/" + std::to_string(pid) + "/task";
  const auto is_stopped = [](const auto& thread) {
    std::string stat;
    std::getline(std::ifstream(thread.path() / "stat"), stat);
    return stat.find(") T ") != std::string::npos;
  };
  return std::ranges::all_of(fs::directory_iterator(threads), is_stopped);
}

std::vector<std::string> Middlewares() { return program::MiddlewareNames(); }

FaultTest::FaultTest() : gcm_address_("127.0.0.1:" + std::to_string(FreePort())) {
  Slowness();  // measured now, before other programs run
  // The viewer uses the same cookie as the programs.
  setenv("XDG_RUNTIME_DIR", home_.path().c_str(), 1);  // NOLINT(concurrency-mt-unsafe): read later
  fs::create_directory(home_.path() / "journals");
  home_.Write("system.json", SystemFile(home_.path() / "journals"));
}

FaultTest::~FaultTest() {
  if (!HasFailure()) return;
  for (const auto* program : {&gcm_, &robot_, &desk_}) {
    if (*program) std::cout << "pid " << (*program)->pid() << " said:\n" << (*program)->err();
  }
}

FaultTest::Environment FaultTest::environment() const {
  const std::string home = home_.path();
  Environment all{{"XDG_RUNTIME_DIR", home},
                  {"XDG_STATE_HOME", home},
                  {"TENDON_COMPONENTS", Built("tests/system/faults/instruments")}};
  all.insert(more_environment_.begin(), more_environment_.end());
  return all;
}

FaultTest::Words FaultTest::Command(const std::string& program, const Words& words) const {
  Words command{Built("bin/" + program),           "--gcm",        gcm_address_, "--timeout",
                std::to_string(Timeout().count()), "--middleware", GetParam()};
  command.insert(command.end(), words.begin(), words.end());
  return command;
}

std::unique_ptr<Program> FaultTest::MakeGcm() const {
  return std::make_unique<Program>(Command("gcm", {"serve"}), environment());
}

void FaultTest::StartGcm() {
  gcm_ = MakeGcm();
  ASSERT_TRUE(Eventually([this] { return gcm_->out().starts_with("GCM at "); })) << gcm_->err();
}

std::unique_ptr<Program> FaultTest::MakeLcm(const std::string& name, const Words& more) const {
  // The history fills before the first footprint, or grows by less than a footprint may grow.
  Words words{"--name", name, "--system", home_.path() / "system.json", "--history-memory", "4MiB"};
  words.insert(words.end(), more.begin(), more.end());
  return std::make_unique<Program>(Command("lcm", words), environment());
}

void FaultTest::StartSystem() {
  ASSERT_NO_FATAL_FAILURE(StartGcm());
  ASSERT_NO_FATAL_FAILURE(StartViewer());
  robot_ = MakeLcm("robot");
  desk_ = MakeLcm("desk");
  ASSERT_TRUE(EventuallyConnected()) << robot_->err() << desk_->err();
  ASSERT_TRUE(Eventually([this] { return IsActive(viewer_->catalogue()); })) << Gcm({"tree"}).out;
  viewer_->telemetry().Subscribe({"robot", "ledger", "state", {"Sample"}}, stream_);
  ASSERT_TRUE(Flows()) << ToString(stream_->verdict());
}

void FaultTest::StartViewer() {
  viewer_ = std::make_unique<tendon::GcmClient>(
      NewMiddleware(),
      tendon::GcmClient::Options{.name = "test", .address = gcm_address_, .timeout = Timeout()},
      watch_);
  const auto watching = viewer_->WaitUntilWatching();
  ASSERT_TRUE(watching) << watching.error().message;
}

Outcome FaultTest::Gcm(Words words) const {
  Program program(Command("gcm", words), environment());
  const auto longer = std::chrono::seconds(10) + std::chrono::ceil<std::chrono::seconds>(Timeout());
  const auto exit_code = program.Wait(longer);
  return {exit_code.value_or(-1), program.out(), program.err()};
}

std::shared_ptr<tendon::Middleware> FaultTest::NewMiddleware() const {
  return *program::MakeMiddleware({.middleware = GetParam()});
}

bool FaultTest::EventuallyIs(const std::string& process, ProcessState state) const {
  return Eventually([&] {
    const auto catalogue = viewer_->catalogue();
    const auto* entry = catalogue.FindProcess(process);
    return entry != nullptr && entry->process.state == state;
  });
}

bool FaultTest::EventuallyActive(const std::string& process, const std::string& component) const {
  return Eventually([&] {
    const auto catalogue = viewer_->catalogue();
    const auto* found = catalogue.FindComponent(process, component);
    return found != nullptr && found->state == tendon::ComponentState::kActive;
  });
}

std::string FaultTest::AddressOf(const std::string& process) const {
  const auto catalogue = viewer_->catalogue();
  const auto* entry = catalogue.FindProcess(process);
  return entry == nullptr ? std::string() : entry->process.address;
}

bool FaultTest::EventuallyConnected() const {
  return Eventually([this] {
    const auto catalogue = viewer_->catalogue();
    const auto* connection = catalogue.FindConnection(kClient);
    return connection != nullptr && connection->state == tendon::ConnectionState::kActive;
  });
}

bool FaultTest::Flows(std::uint64_t rows) const {
  const std::uint64_t before = stream_->received();
  return EventuallyExecutesMore() &&
         Eventually([&] { return stream_->received() >= before + rows; });
}

bool FaultTest::EventuallyExecutesMore(std::size_t clients) const {
  constexpr std::size_t kMore = 10;
  const auto before = Executed();
  return Eventually([&] {
    const auto now = Executed();
    const auto busy = std::count_if(now.begin(), now.end(), [&](const auto& client) {
      const auto then = before.find(client.first);
      return client.second >= kMore + (then == before.end() ? 0 : then->second);
    });
    return static_cast<std::size_t>(busy) >= clients;
  });
}

std::map<std::string, std::size_t> FaultTest::Executed() const {
  std::map<std::string, std::size_t> executed;
  ForEachJournal("executed",
                 [&](const std::string& line) { ++executed[line.substr(0, line.find(' '))]; });
  return executed;
}

std::size_t FaultTest::Lines(const std::string& kind, const std::string& words) const {
  std::size_t lines = 0;
  ForEachJournal(kind, [&](const std::string& line) {
    if (line.find(words) != std::string::npos) ++lines;
  });
  return lines;
}

template <typename Read>
void FaultTest::ForEachJournal(const std::string& kind, Read read) const {
  for (const auto& entry : fs::directory_iterator(home_.path() / "journals")) {
    if (!entry.path().filename().string().starts_with(kind + "-")) continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) read(line);
  }
}

void FaultTest::ExpectHonestCommands() {
  for (auto* program : {&robot_, &desk_}) {
    if (!*program) continue;
    (*program)->Signal(SIGKILL);
    (*program)->Wait();
  }
  const CommandVerdict verdict = CheckCommands(home_.path() / "journals");
  Tell(ToString(verdict));
  EXPECT_GT(verdict.done, 0U);
  EXPECT_THAT(verdict.mistakes, testing::IsEmpty());
}

void FaultTest::ExpectNoRowLost() const {
  const StreamChecker::Verdict verdict = stream_->verdict();
  Tell(ToString(verdict));
  EXPECT_EQ(verdict.missing, verdict.counted);
  EXPECT_EQ(verdict.repeated, 0U);
  EXPECT_EQ(verdict.damaged, 0U);
  EXPECT_EQ(verdict.ledgers, 1U);
  if (MayExpireLeases()) return;
  EXPECT_EQ(verdict.missing, 0U);
  EXPECT_EQ(verdict.subscriptions, 1U);
  EXPECT_THAT(verdict.stale, testing::IsEmpty());
}

void FaultTest::ExpectNeverLost(const std::string& process) const {
  EXPECT_THAT(watch_->double_holders(), testing::IsEmpty());
  if (MayExpireLeases()) return;
  EXPECT_EQ(watch_->Count(process, ProcessState::kLost), 0U) << process;
}

bool FaultTest::MayExpireLeases() const {
  if (tendon::test::IsSanitized()) return true;
  if (!stalls_.has_stood_still()) return false;
  Tell("the machine stood still for " + std::to_string(stalls_.longest().count()) +
       " ms: whether anybody was lost is not judged");
  return true;
}

void FaultTest::Tell(const std::string& line) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::cout << test->test_suite_name() << "." << test->name() << ": " << line << std::endl;
}

}  // namespace faults
