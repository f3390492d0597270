#include <gcm_console/feeds/connection_feed.h>
#include <gcm_console/feeds/health_feed.h>
#include <gcm_console/feeds/task_feed.h>
#include <gcm_console/output/catalogue_json.h>
#include <gcm_console/output/screen.h>
#include <gcm_console/output/table.h>
#include <gcm_console/output/text.h>
#include <gcm_console/verbs/queries.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/base/os/keyboard.h>
#include <tendon/base/os/terminal.h>
#include <tendon/base/os/termination.h>
#include <tendon/base/text.h>
#include <tendon/gcm/staleness.h>
#include <tendon/gcm/text.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

namespace console {
namespace {

using program::ExitCode;
using tendon::Result;
using tendon::message::SystemHealth;
using namespace std::chrono_literals;

struct TopOptions {
  std::string sort = "load";  // order of the tasks
  std::string sort_connections = "rate";
  std::string filter;
  bool shows_connections = false;
};

/// An order of rows: the key on the keyboard, and the name for the option.
template <typename Figures>
struct Order {
  char key;
  const char* name;
  bool (*less)(const Figures&, const Figures&);
};

constexpr Order<TaskFigures> kOrders[] = {
    {'n', "name", [](const TaskFigures& a, const TaskFigures& b) { return a.path < b.path; }},
    {'r', "rate", [](const TaskFigures& a, const TaskFigures& b) { return a.rate > b.rate; }},
    {'t', "late", [](const TaskFigures& a, const TaskFigures& b) { return a.latest > b.latest; }},
    {'l', "load", [](const TaskFigures& a, const TaskFigures& b) { return a.load > b.load; }},
    {'s', "skipped",
     [](const TaskFigures& a, const TaskFigures& b) { return a.skipped > b.skipped; }}};

using Of = ConnectionFigures;
constexpr Order<Of> kConnectionOrders[] = {
    {'n', "name", [](const Of& a, const Of& b) { return a.required < b.required; }},
    {'r', "rate", [](const Of& a, const Of& b) { return a.rate > b.rate; }},
    {'t', "round-trip", [](const Of& a, const Of& b) { return a.round_trip > b.round_trip; }},
    {'w', "waiting", [](const Of& a, const Of& b) { return a.waiting > b.waiting; }},
    {'s', "lost", [](const Of& a, const Of& b) { return a.lost > b.lost; }}};

template <typename Figures, std::size_t kCount>
void SortBy(const std::string& name, const Order<Figures> (&orders)[kCount],
            std::vector<Figures>& all) {
  for (const auto& order : orders) {
    if (order.name == name) std::stable_sort(all.begin(), all.end(), order.less);
  }
}

template <typename Figures, std::size_t kCount>
bool Sorts(const std::string& name, const Order<Figures> (&orders)[kCount]) {
  return std::ranges::any_of(orders, [&](const auto& order) { return order.name == name; });
}

void Arrange(std::vector<TaskFigures>& tasks, const TopOptions& options) {
  std::erase_if(tasks, [&](const TaskFigures& task) {
    return task.path.find(options.filter) == std::string::npos;
  });
  SortBy(options.sort, kOrders, tasks);
}

void Arrange(std::vector<ConnectionFigures>& connections, const TopOptions& options) {
  SortBy(options.sort_connections, kConnectionOrders, connections);
}

Table TableOf(const std::vector<TaskFigures>& tasks) {
  constexpr double kMicro = 1e6;
  constexpr double kPercent = 100.0;
  Table table({"TASK", "STATE", "RATE/Hz", "LATE/us", "LATEST/us", "COMPUTE/us", "LOAD/%",
               "SKIPPED", "DETAIL"});
  for (const TaskFigures& task : tasks) {
    if (!task.is_known) {
      const std::string state =
          task.age ? task.state + " " + tendon::AgeText(*task.age) : task.state;
      table.Add({task.path, state, "-", "-", "-", "-", "-", "-", task.detail});
      continue;
    }
    table.Add({task.path, task.state, Fixed(task.rate, 1), Fixed(task.late * kMicro, 0),
               Fixed(task.latest * kMicro, 0), Fixed(task.compute * kMicro, 1),
               Fixed(task.load * kPercent, 1), std::to_string(task.skipped), task.detail});
  }
  return table;
}

Table TableOf(const std::vector<ConnectionFigures>& connections) {
  constexpr double kMilli = 1e3;
  Table table({"REQUIRED", "PROVIDED", "STATE", "RATE/Hz", "ROUND-TRIP/ms", "WAITING", "LOST"});
  for (const ConnectionFigures& one : connections) {
    if (!one.is_known) {
      table.Add({one.required, one.provided, one.state, "-", "-", "-", "-"});
      continue;
    }
    table.Add({one.required, one.provided, one.state, Fixed(one.rate, 1),
               one.round_trip < 0.0 ? "-" : Fixed(one.round_trip * kMilli, 2),
               std::to_string(one.waiting) + "/" + std::to_string(one.capacity),
               std::to_string(one.lost)});
  }
  return table;
}

/// Returns the processes that use the most processor time, because not all processes fit.
Table BusiestOf(const tendon::Catalogue& catalogue, const SystemHealth& health) {
  constexpr std::size_t kMax = 5;
  std::vector<const tendon::ProcessDescription*> processes;
  for (const auto& [name, entry] : catalogue.processes()) processes.push_back(&entry.process);
  const auto cpu = [&](const auto* process) {
    const auto* known = FindHealth(health, *process);
    return known == nullptr ? -1.0 : known->cpu;
  };
  std::ranges::stable_sort(processes, std::ranges::greater(), cpu);
  processes.resize(std::min(processes.size(), kMax));
  Table table({"PROCESS", "STATE", "CPU", "MEMORY"});
  for (const auto* process : processes) {
    const auto* known = FindHealth(health, *process);
    table.Add({process->name, std::string(ToString(process->state)), tendon::CpuText(known),
               tendon::MemoryText(known)});
  }
  return table;
}

nlohmann::ordered_json HealthJson(const tendon::Catalogue& catalogue, const SystemHealth& health) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const auto& [name, entry] : catalogue.processes()) {
    all.push_back({{"name", name},
                   {"state", ToString(entry.process.state)},
                   {"health", HealthOf(health, entry.process)}});
  }
  return all;
}

nlohmann::ordered_json FiguresJson(const std::vector<ConnectionFigures>& connections) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const ConnectionFigures& figures : connections) {
    nlohmann::ordered_json one = {
        {"required", figures.required}, {"provided", figures.provided}, {"state", figures.state}};
    if (figures.is_known) {
      one["rate_hz"] = figures.rate;
      if (figures.round_trip >= 0.0) one["round_trip_s"] = figures.round_trip;
      one["waiting"] = figures.waiting;
      one["capacity"] = figures.capacity;
      one["lost"] = figures.lost;
    }
    all.push_back(std::move(one));
  }
  return all;
}

nlohmann::ordered_json FiguresJson(const std::vector<TaskFigures>& tasks) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const TaskFigures& task : tasks) {
    nlohmann::ordered_json one = {
        {"path", task.path}, {"state", task.state}, {"detail", task.detail}};
    if (task.age) one["age_s"] = std::chrono::duration<double>(*task.age).count();
    if (task.is_known) {
      one["rate_hz"] = task.rate;
      one["late_s"] = task.late;
      one["latest_s"] = task.latest;
      one["compute_s"] = task.compute;
      one["load"] = task.load;
      one["skipped"] = task.skipped;
    }
    all.push_back(std::move(one));
  }
  return all;
}

std::vector<TaskFigures> LookAt(TaskFeed& feed, const TopOptions& /*options*/) {
  return feed.Look();
}

std::vector<ConnectionFigures> LookAt(ConnectionFeed& feed, const TopOptions& options) {
  return feed.Look(options.filter);
}

/// Prints the figures once, as soon as all are known or the time limit has passed.
template <typename Feed>
Result<ExitCode> PrintOnce(Context& context, tendon::GcmClient& client, const TopOptions& options,
                           const char* what) {
  const auto deadline = std::chrono::steady_clock::now() + 2s;
  Feed feed(client);
  auto all = LookAt(feed, options);
  const auto is_awaited = [](const auto& one) { return one.is_awaited; };
  while (std::ranges::any_of(all, is_awaited) && std::chrono::steady_clock::now() < deadline) {
    if (tendon::os::TerminationRequested(20ms)) return program::kInterrupted;
    all = LookAt(feed, options);
  }
  Arrange(all, options);
  if (!context.settings().json) {
    context.Print(TableOf(all));
    return program::kOk;
  }
  const SystemHealth health = AskHealth(context);
  context.PrintJson(
      {{"processes", HealthJson(client.catalogue(), health)}, {what, FiguresJson(all)}});
  return program::kOk;
}

/// The settings that the user changes with keys. While `is_typing` is true, the user types the
/// filter.
struct TopKeys {
  bool is_typing = false;
  bool wants_end = false;
};

void Press(char key, TopKeys& keys, TopOptions& options) {
  constexpr char kDelete = 0x7f;
  constexpr char kEscape = 0x1b;
  if (keys.is_typing) {
    if (key == '\n' || key == '\r') {
      keys.is_typing = false;
    } else if (key == kEscape) {
      keys.is_typing = false;
      options.filter.clear();
    } else if (key == kDelete || key == '\b') {
      if (!options.filter.empty()) options.filter.pop_back();
    } else if (key >= ' ') {
      options.filter += key;
    }
    return;
  }
  if (key == 'q') keys.wants_end = true;
  if (key == '/') {
    keys.is_typing = true;
    options.filter.clear();
  }
  if (key == 'c') options.shows_connections = !options.shows_connections;
  if (options.shows_connections) {
    for (const auto& order : kConnectionOrders) {
      if (order.key == key) options.sort_connections = order.name;
    }
    return;
  }
  for (const auto& order : kOrders) {
    if (order.key == key) options.sort = order.name;
  }
}

/// Returns the text of the screen: the processes, and below them the table of one feed.
template <typename Figures>
std::string ScreenText(const Table& processes, const std::vector<Figures>& all,
                       const std::string& what, const TopOptions& options, const TopKeys& keys,
                       const TableLayout& layout) {
  std::ostringstream picture;
  processes.Print(picture, layout);
  picture << '\n'
          << tendon::Counted(all.size(), what, what + "s") << ", by "
          << (options.shows_connections ? options.sort_connections : options.sort);
  if (keys.is_typing || !options.filter.empty()) picture << ", with '" << options.filter << "'";
  picture << (keys.is_typing ? "_  (Enter, Esc)" : "") << "\n\n";
  TableOf(all).Print(picture, layout);
  return picture.str();
}

// A narrow terminal shows only the beginning of this line.
constexpr const char* kKeyLine =
    "keys: q end; sort by n name, r rate, t latest, l load, s skipped; / filter; c connections";
constexpr const char* kConnectionKeyLine =
    "keys: q end; sort by n name, r rate, t round trip, w waiting, s lost; / filter; c tasks";

ExitCode ShowAlways(Context& context, tendon::GcmClient& client, TopOptions options) {
  TaskFeed tasks(client);
  ConnectionFeed connections(client);
  HealthFeed health(client);
  tendon::os::Keyboard keyboard;
  Screen screen(context.out());
  TopKeys keys;
  while (!keys.wants_end) {
    const Table processes = BusiestOf(client.catalogue(), health.Look());
    TableLayout layout = context.layout();
    layout.columns = tendon::os::TerminalColumns(tendon::os::Stream::kOutput);
    const auto draw = [&](auto all, const char* what) {
      Arrange(all, options);
      return ScreenText(processes, all, what, options, keys, layout);
    };
    const bool is_of_connections = options.shows_connections;
    screen.Show(is_of_connections ? draw(LookAt(connections, options), "connection")
                                  : draw(tasks.Look(), "task"),
                is_of_connections ? kConnectionKeyLine : kKeyLine, tendon::os::TerminalRows());
    if (const auto key = keyboard.NextKey(200ms)) Press(*key, keys, options);
    screen.PauseIfAsked(keyboard);
    if (tendon::os::TerminationRequested(0ms)) return program::kInterrupted;
  }
  return program::kOk;
}

Result<ExitCode> Top(Context& context, const TopOptions& options) {
  tendon::os::HoldTerminationSignals();
  const auto client = context.Client();
  if (!client) return client.error();
  const bool is_once = !context.has_screen() || context.settings().json;
  if (is_once && options.shows_connections) {
    return PrintOnce<ConnectionFeed>(context, **client, options, "connections");
  }
  if (is_once) return PrintOnce<TaskFeed>(context, **client, options, "tasks");
  return ShowAlways(context, **client, options);
}

Verb::Run Prepare(CLI::App& app) {
  auto options = std::make_shared<TopOptions>();
  std::vector<std::string> orders;
  for (const auto& order : kOrders) orders.emplace_back(order.name);
  for (const auto& order : kConnectionOrders) {
    if (!Sorts(order.name, kOrders)) orders.emplace_back(order.name);
  }
  const auto* sort = app.add_option("--sort", options->sort, "the column to sort by")
                         ->check(CLI::IsMember(orders))
                         ->capture_default_str();
  app.add_option("--filter", options->filter, "show only rows whose path contains this text");
  app.add_flag("--connections", options->shows_connections,
               "show all connections instead of all tasks; the rate counts calls and events in "
               "mailboxes, but not reads");
  return [options, sort](Context& context) -> Result<ExitCode> {
    if (sort->count() == 0) return Top(context, *options);
    const std::string& by = options->sort;
    if (options->shows_connections && !Sorts(by, kConnectionOrders)) {
      return Error{ErrorCode::kInvalid, "--sort " + by + " is for tasks, not for --connections"};
    }
    if (!options->shows_connections && !Sorts(by, kOrders)) {
      return Error{ErrorCode::kInvalid, "--sort " + by + " is for --connections, not for tasks"};
    }
    if (options->shows_connections)
      options->sort_connections = std::exchange(options->sort, "load");
    return Top(context, *options);
  };
}

}  // namespace

std::vector<Verb> TopVerbs() {
  return {{"top",
           "show the timing of all tasks: on the whole screen, or once if the output is a pipe",
           &Prepare,
           {"gcm top --sort late", "gcm top --connections --sort lost",
            "gcm top --filter robot/ | column -t"}}};
}

}  // namespace console
