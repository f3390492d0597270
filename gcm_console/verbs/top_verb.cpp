#include <gcm_console/catalogue_json.h>
#include <gcm_console/report.h>
#include <gcm_console/screen/health_feed.h>
#include <gcm_console/screen/screen.h>
#include <gcm_console/screen/task_feed.h>
#include <gcm_console/verb.h>
#include <tendon/base/os/screen/keyboard.h>
#include <tendon/base/os/terminal.h>
#include <tendon/base/os/termination.h>
#include <tendon/gcm/text/health_text.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

namespace console {
namespace {

using program::ExitCode;
using tendon::Result;
using tendon::message::SystemHealth;
using namespace std::chrono_literals;

struct TopOptions {
  std::string sort = "load";
  std::string filter;
};

using Less = bool (*)(const TaskFigures&, const TaskFigures&);

/// The key that sorts by it, and what the option calls it.
struct Order {
  char key;
  const char* name;
  Less less;
};

constexpr Order kOrders[] = {
    {'n', "name", [](const TaskFigures& a, const TaskFigures& b) { return a.path < b.path; }},
    {'r', "rate", [](const TaskFigures& a, const TaskFigures& b) { return a.rate > b.rate; }},
    {'t', "late", [](const TaskFigures& a, const TaskFigures& b) { return a.latest > b.latest; }},
    {'l', "load", [](const TaskFigures& a, const TaskFigures& b) { return a.load > b.load; }},
    {'s', "skipped",
     [](const TaskFigures& a, const TaskFigures& b) { return a.skipped > b.skipped; }}};

void Arrange(std::vector<TaskFigures>& tasks, const TopOptions& options) {
  std::erase_if(tasks, [&](const TaskFigures& task) {
    return task.path.find(options.filter) == std::string::npos;
  });
  for (const Order& order : kOrders) {
    if (order.name == options.sort) std::stable_sort(tasks.begin(), tasks.end(), order.less);
  }
}

Table TableOf(const std::vector<TaskFigures>& tasks) {
  constexpr double kMicro = 1e6;
  constexpr double kPercent = 100.0;
  Table table(
      {"TASK", "STATE", "RATE/Hz", "LATE/us", "LATEST/us", "COMPUTE/us", "LOAD/%", "SKIPPED"});
  for (const TaskFigures& task : tasks) {
    if (!task.is_known) {
      table.Add({task.path, task.state, "-", "-", "-", "-", "-", "-"});
      continue;
    }
    table.Add({task.path, task.state, Fixed(task.rate, 1), Fixed(task.late * kMicro, 0),
               Fixed(task.latest * kMicro, 0), Fixed(task.compute * kMicro, 1),
               Fixed(task.load * kPercent, 1), std::to_string(task.skipped)});
  }
  return table;
}

/// Those that use most, for there is not room for all.
Table BusiestOf(const tendon::Catalog& catalog, const SystemHealth& health) {
  constexpr std::size_t kMost = 5;
  std::vector<const tendon::ProcessDescription*> processes;
  for (const auto& [name, entry] : catalog.processes()) processes.push_back(&entry.process);
  const auto cpu = [&](const auto* process) {
    const auto* known = FindHealth(health, *process);
    return known == nullptr ? -1.0 : known->cpu;
  };
  std::ranges::stable_sort(processes, std::ranges::greater(), cpu);
  processes.resize(std::min(processes.size(), kMost));
  Table table({"PROCESS", "STATE", "CPU", "MEMORY"});
  for (const auto* process : processes) {
    const auto* known = FindHealth(health, *process);
    table.Add({process->name, std::string(ToString(process->state)), tendon::CpuText(known),
               tendon::MemoryText(known)});
  }
  return table;
}

nlohmann::ordered_json JsonOf(const tendon::Catalog& catalog, const SystemHealth& health) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const auto& [name, entry] : catalog.processes()) {
    all.push_back({{"name", name},
                   {"state", ToString(entry.process.state)},
                   {"health", HealthOf(health, entry.process)}});
  }
  return all;
}

void PrintJson(Context& context, const std::vector<TaskFigures>& tasks,
               nlohmann::ordered_json processes) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const TaskFigures& task : tasks) {
    nlohmann::ordered_json one = {{"path", task.path}, {"state", task.state}};
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
  context.PrintJson({{"processes", std::move(processes)}, {"tasks", std::move(all)}});
}

/// Once each task has told of a second, or has had the time for it.
Result<ExitCode> PrintOnce(Context& context, tendon::GcmClient& client, const TopOptions& options) {
  const auto deadline = std::chrono::steady_clock::now() + 2s;
  TaskFeed feed(client);
  auto tasks = feed.Look();
  const auto is_known = [](const TaskFigures& task) { return task.is_known; };
  while (!std::all_of(tasks.begin(), tasks.end(), is_known) &&
         std::chrono::steady_clock::now() < deadline) {
    if (tendon::os::TerminationAsked(20ms)) return program::kInterrupted;
    tasks = feed.Look();
  }
  Arrange(tasks, options);
  if (context.settings().json) {
    const auto health = context.Ask<SystemHealth>(
        [](tendon::GcmClient& asked, auto handler) { asked.GetHealth(handler); });
    PrintJson(context, tasks, JsonOf(client.catalog(), health ? *health : SystemHealth{}));
  } else {
    context.Print(TableOf(tasks));
  }
  return program::kOk;
}

/// What the keys have changed; `is_typing` is of the filter.
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
  for (const Order& order : kOrders) {
    if (order.key == key) options.sort = order.name;
  }
}

std::string PictureOf(const Table& processes, const std::vector<TaskFigures>& tasks,
                      const TopOptions& options, const TopKeys& keys, const Layout& layout) {
  std::ostringstream picture;
  processes.Print(picture, layout);
  picture << '\n';
  picture << tasks.size() << (tasks.size() == 1 ? " task" : " tasks") << ", by " << options.sort;
  if (keys.is_typing || !options.filter.empty()) picture << ", with '" << options.filter << "'";
  picture << (keys.is_typing ? "_  (Enter, Esc)" : "") << "\n\n";
  TableOf(tasks).Print(picture, layout);
  return picture.str();
}

constexpr const char* kKeyLine =
    "sort: n name, r rate, t latest, l load, s skipped; / filter, q end";

ExitCode ShowAlways(Context& context, tendon::GcmClient& client, TopOptions options) {
  TaskFeed feed(client);
  HealthFeed health(client);
  tendon::os::Keyboard keyboard;
  Screen screen(context.out());
  TopKeys keys;
  while (!keys.wants_end) {
    auto tasks = feed.Look();
    Arrange(tasks, options);
    const Table processes = BusiestOf(client.catalog(), health.Look());
    Layout layout = context.layout();
    layout.columns = tendon::os::TerminalColumns(tendon::os::Stream::kOutput);
    screen.Show(PictureOf(processes, tasks, options, keys, layout), kKeyLine,
                tendon::os::TerminalRows());
    if (const auto key = keyboard.NextKey(200ms)) Press(*key, keys, options);
    screen.PauseIfAsked(keyboard);
    if (tendon::os::TerminationAsked(0ms)) return program::kInterrupted;
  }
  return program::kOk;
}

Result<ExitCode> Top(Context& context, const TopOptions& options) {
  tendon::os::HoldTerminationSignals();
  const auto client = context.Client();
  if (!client) return client.error();
  const bool is_typed = context.streams().make_line_reader != nullptr;
  if (!is_typed || context.settings().json) return PrintOnce(context, **client, options);
  return ShowAlways(context, **client, options);
}

Verb::Run Prepare(CLI::App& app) {
  auto options = std::make_shared<TopOptions>();
  std::vector<std::string> orders;
  for (const Order& order : kOrders) orders.emplace_back(order.name);
  app.add_option("--sort", options->sort, "what comes first")
      ->check(CLI::IsMember(orders))
      ->capture_default_str();
  app.add_option("--filter", options->filter, "only tasks with this in their path");
  return [options](Context& context) { return Top(context, *options); };
}

}  // namespace

std::vector<Verb> TopVerbs() {
  return {{"top",
           "show how all tasks keep their time, on the whole screen or once into a pipe",
           &Prepare,
           {"gcm top --sort late", "gcm top --filter robot/ | column -t"}}};
}

}  // namespace console
