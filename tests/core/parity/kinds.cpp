#include "core/parity/kinds.h"

#include <tendon/task/callback_task.h>
#include <tendon/task/continuous_task.h>
#include <tendon/task/main_task.h>
#include <tendon/task/periodic_task.h>
#include <tendon/task/signal_task.h>

#include <chrono>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace tendon_test {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::nanoseconds kPeriod = 500us;
constexpr std::size_t kHistoryLength = 7;

template <typename Base>
constexpr bool kIsTask = std::derived_from<Base, tendon::Task>;

/// A component of some kind that is also a server or a client. Contains the code that depends on
/// the kind.
template <typename Base, typename SomePart>
class Stage : public Base, public SomePart {
 public:
  template <typename... Arguments>
  explicit Stage(std::string name, Arguments... arguments) : Base(std::move(name), arguments...) {
    this->AddDesk(this->AddProvidedInterface("Desk"));
  }

  tendon::Component& component() final { return *this; }
  void Drive() final {
    if constexpr (std::derived_from<Base, tendon::MainTask>) {
      this->RunInThisThread();
    } else if constexpr (std::derived_from<Base, tendon::CallbackTask>) {
      this->Cycle();
    }
  }

 private:
  void Run() {
    this->NoteRun();
    if constexpr (kIsTask<Base>) this->ProcessQueuedCommands();
    if constexpr (std::derived_from<Base, tendon::ContinuousTask>) std::this_thread::yield();
  }
};

/// The tables of a server, which is a task or a component without cycles.
template <typename Base>
struct Tables {
  tendon::StateTable table;
  tendon::StateTable history{"history"};
};

template <typename Base>
class Server final : public Stage<Base, ServerPart> {
 public:
  template <typename... Arguments>
  explicit Server(std::string name, Arguments... arguments)
      : Stage<Base, ServerPart>(std::move(name), arguments...) {
    if constexpr (kIsTask<Base>) {
      this->table = &this->state_table();
      this->FillHistory(this->AddStateTable("history"));
    } else {
      this->table = &own_.table;
      this->FillHistory(own_.history);
    }
    std::size_t index = 0;
    ForEachPort(this->ports, [&](auto& port) {
      const std::string payload = kPortNames.at(index++);
      port.AddTo(this->AddProvidedInterface(payload), *this->table, payload);
    });
    this->messages = std::make_unique<tendon::StatusMessages>(
        this->AddProvidedInterface("Messages"), this->name());
  }

  void Publish() override {
    if constexpr (!kIsTask<Base>) own_.table.Advance(tendon::SteadyClock().Now());
  }

 private:
  struct Nothing {};
  std::conditional_t<kIsTask<Base>, Nothing, Tables<Base>> own_;
};

template <typename Base>
class Client final : public Stage<Base, ClientPart> {
 public:
  template <typename... Arguments>
  explicit Client(std::string name, Arguments... arguments)
      : Stage<Base, ClientPart>(std::move(name), arguments...) {
    // Reads of another process have this time; the default is too short for a machine that stalls.
    constexpr std::chrono::seconds kReadDeadline(60);
    std::size_t index = 0;
    ForEachPort(this->ports, [&](auto& port) {
      auto& required = this->AddRequiredInterface(kPortNames.at(index++));
      required.SetReadDeadline(kReadDeadline);
      port.AddTo(required);
    });
    auto& messages = this->AddRequiredInterface("Messages");
    messages.SetReadDeadline(kReadDeadline);
    this->AddMessages(messages);
    this->AddRequiredInterface("Spare", tendon::Need::kOptional)
        .AddFunction(this->optional, "Step");
  }
};

class Leader final : public tendon::PeriodicTask {
 public:
  explicit Leader(std::string name) : PeriodicTask(std::move(name), kPeriod) {}

 private:
  void Run() override {}
};

template <template <typename> typename Role>
auto& Add(tendon::LocalManager& manager, Kind kind, const std::string& name) {
  using Result = std::conditional_t<std::is_base_of_v<ServerPart, Role<tendon::Component>>,
                                    ServerPart, ClientPart>;
  const auto as_part = [](auto& component) -> Result& { return component; };
  switch (kind) {
    case Kind::kPeriodic:
      return as_part(manager.Add<Role<tendon::PeriodicTask>>(name, kPeriod));
    case Kind::kContinuous:
      return as_part(manager.Add<Role<tendon::ContinuousTask>>(name));
    case Kind::kSignal:
      return as_part(manager.Add<Role<tendon::SignalTask>>(name));
    case Kind::kCallback:
      return as_part(manager.Add<Role<tendon::CallbackTask>>(name));
    case Kind::kMain:
      return as_part(manager.Add<Role<tendon::MainTask>>(name, kPeriod));
    case Kind::kFollower: {
      manager.Add<Leader>("leader-of-" + name);
      auto& follower = manager.Add<Role<tendon::SignalTask>>(name);
      const auto follows = manager.RunAfter(name, "leader-of-" + name);
      if (!follows) throw std::runtime_error(follows.error().message);
      return as_part(follower);
    }
    case Kind::kThreadless:
      return as_part(manager.Add<Role<tendon::Component>>(name));
  }
  throw std::logic_error("no such kind");
}

}  // namespace

std::string_view NameOf(Kind kind) {
  constexpr std::array<std::string_view, 7> kNames = {
      "Periodic", "Continuous", "Signal", "Callback", "Main", "Follower", "Threadless"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::vector<Kind> AllKinds() {
  std::vector<Kind> kinds = TaskKinds();
  kinds.push_back(Kind::kThreadless);
  return kinds;
}

std::vector<Kind> TaskKinds() {
  return {Kind::kPeriodic, Kind::kContinuous, Kind::kSignal,
          Kind::kCallback, Kind::kMain,       Kind::kFollower};
}

void Part::NoteRun() {
  ++runs;
  run_thread = std::this_thread::get_id();
  if (throws_in_run) throw std::runtime_error("cable cut");
}

void ServerPart::FillHistory(tendon::StateTable& history_table) {
  history = &history_table;
  history->SetLength(kHistoryLength);
  history->AdvanceOnlyByHand();
  history->Add(number, "Number");
  const auto twice = [](const int& in, int& out) noexcept { out = 2 * in; };
  history->AddFiltered(number, doubled, twice, "Doubled");
  std::size_t index = 0;
  ForEachPort(ports, [&](auto& port) { port.AddGoalTo(*history, kPortNames.at(index++)); });
}

void ClientPart::AddMessages(tendon::RequiredInterface& interface) {
  interface.AddEventHandlerWrite(&ClientPart::OnStatus, this, "Status");
  interface.AddEventHandlerWrite(&ClientPart::OnWarning, this, "Warning");
  interface.AddEventHandlerWrite(&ClientPart::OnError, this, "Error");
}

ServerPart& AddServer(tendon::LocalManager& manager, Kind kind) {
  return Add<Server>(manager, kind, "server");
}

ClientPart& AddClient(tendon::LocalManager& manager, Kind kind) {
  return Add<Client>(manager, kind, "client");
}

}  // namespace tendon_test
