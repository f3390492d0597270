#include <gcm_console/output/table.h>
#include <gcm_console/verbs/queries.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/base/os/process.h>
#include <tendon/base/os/socket.h>
#include <tendon/gcm/diagnosis.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/text.h>
#include <tendon/gcm/waiting.h>
#include <tendon/middleware/hello.h>
#include <tendon/process/membership/advertised_address.h>
#include <tendon/process/version_messages.h>
#include <tendon/security/certificate_check.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

namespace console {
namespace {

using program::ExitCode;
using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;
using namespace std::chrono_literals;

/// The result of a check: the checked object, the verdict, and a text.
struct Finding {
  enum class Verdict { kGood, kBad, kUnknown };

  std::string what;
  Verdict verdict = Verdict::kGood;
  std::string text;
  std::string fix = {};  ///< the remedy, if the verdict is kBad
};
using Findings = std::vector<Finding>;

/// Receives the clock offset of a process with the first rows of one of its tables.
class ClockListener final : public tendon::RowSink {
 public:
  struct Clock {
    std::chrono::nanoseconds offset{0};
    std::chrono::nanoseconds uncertainty{0};
  };

  void OnSubscribed(const std::vector<tendon::Schema>& /*columns*/) override {}
  void OnRows(const tendon::RowBatch& batch) override {
    const bool is_estimated = batch.clock_uncertainty != std::chrono::nanoseconds::max();
    const std::scoped_lock lock(mutex_);
    if (is_estimated) clock_ = {batch.clock_offset, batch.clock_uncertainty};
  }
  void OnStale(const Error& /*reason*/) override {}

  std::optional<Clock> clock() {
    const std::scoped_lock lock(mutex_);
    return clock_;
  }

 private:
  std::mutex mutex_;
  std::optional<Clock> clock_;
};

class Doctor {
 public:
  explicit Doctor(Context& context) : context_(context) {}

  Findings Examine() {
    ExamineProgram();
    ExamineSecrets();
    const auto client = context_.Client();
    if (!client) {
      Bad("GCM", client.error().message,
          client.error().code == ErrorCode::kUnreachable
              ? "start a GCM with gcm serve, or give the address of a running GCM with --gcm"
              : "see --gcm, --certificate and --insecure in gcm help");
      if (client.error().code == ErrorCode::kUnreachable) ExaminePort();
      return std::move(findings_);
    }
    ExamineGcm(**client);
    const tendon::Catalogue catalogue = (*client)->catalogue();
    if (catalogue.processes().empty()) {
      Bad("processes", "no process has joined this GCM",
          "lcm --name NAME --gcm " + context_.settings().gcm);
    }
    health_ = AskHealth(context_);
    for (const auto& [name, entry] : catalogue.processes()) {
      const bool answers = ExamineProcess(**client, entry);
      if (IsPresent(entry.process)) {
        ExaminePlugins(name, answers ? AskForPlugins(entry.process) : entry.process.plugins,
                       answers);
      }
      ExamineComponents(entry);
    }
    ExamineConnections(catalogue);
    return std::move(findings_);
  }

 private:
  void Good(const std::string& what, const std::string& text) {
    findings_.push_back({what, Finding::Verdict::kGood, text});
  }
  void Bad(const std::string& what, const std::string& text, const std::string& fix) {
    findings_.push_back({what, Finding::Verdict::kBad, text, fix});
  }

  void ExamineProgram() {
    Good("gcm", tendon::VersionText(own_) + ", over " + context_.settings().network.middleware +
                    ", on host " + tendon::os::HostName());
    if (tendon::os::RunsAsRoot()) {
      findings_.push_back({"user", Finding::Verdict::kUnknown,
                           "gcm runs as root; no program of Tendon needs the rights of root"});
    }
  }
  void ExamineSecrets() {
    const auto& network = context_.settings().network;
    if (network.certificate.empty()) {
      const auto cookie = tendon::LoopbackCookie();
      if (cookie) {
        Good("cookie", "read from " + tendon::os::RuntimeFolder().string());
      } else {
        Bad("cookie", cookie.error().message, "as the owner of the file: chmod 600");
      }
      return;
    }
    const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    const auto checked =
        tendon::CheckCertificate(network.certificate, program::AuthorityOf(network), now);
    if (!checked) {
      Bad("certificate", checked.error().message, "gcm cert check " + network.certificate);
    } else if (!checked->warning.empty()) {
      Bad("certificate", checked->warning, "gcm cert issue " + checked->certificate.name);
    } else {
      Good("certificate", "of " + checked->certificate.name + ", valid until " +
                              tendon::DateText(checked->certificate.not_after));
    }
  }
  /// If a local GCM does not answer, checks which program uses its port.
  void ExaminePort() {
    const std::string& gcm = context_.settings().gcm;
    const auto place = tendon::ParseAddress(gcm, 1);
    if (!place || !tendon::IsOfOneHost(gcm)) return;
    if (const auto holder = tendon::os::HolderOf(place->port)) {
      Bad("port", gcm + " is used by " + *holder + ", which does not answer as a GCM",
          "end that program; or, to use another port: gcm serve --gcm HOST:PORT, and set "
          "$TENDON_GCM to the same address");
    } else {
      Good("port", gcm + " is free: no program listens there");
    }
  }
  void ExamineGcm(tendon::GcmClient& client) {
    const auto begin = std::chrono::steady_clock::now();
    const auto history = context_.Ask<tendon::message::History>(
        [](tendon::GcmClient& asked, auto handler) { asked.GetHistory(handler); });
    const auto passed = std::chrono::steady_clock::now() - begin;
    const std::string place = "at " + context_.settings().gcm;
    if (!history) {
      Bad("GCM", place + ": " + history.error().message, "gcm log --level error");
      return;
    }
    AddVersion(
        "GCM", AskForVersion(""),
        place + ", answers within " + tendon::MillisecondsText(passed) + ", revision " +
            std::to_string(client.catalogue().revision()),
        "restart the GCM with gcm serve of this release; the system keeps running meanwhile");
  }
  /// Checks a process. Returns true if it answers.
  bool ExamineProcess(tendon::GcmClient& client, const tendon::ProcessEntry& entry) {
    const auto& process = entry.process;
    const std::string what = "process " + process.name;
    const std::string place = "on " + process.host + ", pid " + std::to_string(process.pid);
    if (process.state == tendon::ProcessState::kStarting) {
      Bad(what, place + ", is starting: it has not joined yet",
          "wait; or, to end the process: gcm kill " + process.name);
      return false;
    }
    if (!IsPresent(process)) {
      const bool has_left = process.state == tendon::ProcessState::kLeft;
      findings_.push_back({what, has_left ? Finding::Verdict::kUnknown : Finding::Verdict::kBad,
                           std::string(ToString(process.state)) + ": " + process.reason,
                           HasFallenSilent(process)
                               ? AdviceFor(process)
                               : "start the process again with the command that started it; or, to "
                                 "remove it from the list: gcm forget " +
                                     process.name});
      return false;
    }
    if (process.state == tendon::ProcessState::kAlive && !process.reason.empty()) {
      const std::size_t fix = process.reason.rfind("; ");
      Bad(what, place + ", " + process.reason.substr(0, fix),
          fix == std::string::npos ? "gcm show " + process.name : process.reason.substr(fix + 2));
      return false;
    }
    const bool is_elsewhere = process.host != tendon::os::HostName();
    if (is_elsewhere && tendon::IsOfOneHost(process.address)) {
      Bad(what,
          place + ", advertises the address " + process.address +
              ", which only the host of the process can reach",
          "start the process with --listen and --advertise and an address of " + process.host);
      return false;
    }
    const auto begin = std::chrono::steady_clock::now();
    const auto reported = AskForVersion(process.name);
    const auto passed = std::chrono::steady_clock::now() - begin;
    if (!reported) {
      const std::string here = tendon::os::HostName();
      const bool is_silent = reported.error().code == ErrorCode::kTimeout;
      Bad(what,
          place + ", at " + process.address + ": " + reported.error().message +
              " (seen from host " + here + ")",
          is_silent ? "the process may hang; to see its log: gcm log --from " + process.name
                    : tendon::FixOfUnreached(process.name, here, reported.error()));
      return false;
    }
    AddVersion(what, reported,
               place + ", at " + process.address + ", answers within " +
                   tendon::MillisecondsText(passed) + UsageText(process) + ClockText(client, entry),
               "build the process with this release, or use gcm of the release of the process");
    return true;
  }
  /// Requests the version of a process; if `process` is empty, the version of the GCM.
  Result<tendon::message::ProgramVersion> AskForVersion(const std::string& process) {
    return context_.Ask<tendon::message::ProgramVersion>(
        [&](tendon::GcmClient& asked, auto handler) { asked.GetVersion(process, handler); });
  }
  /// Reports the version of a program. A release that differs from the release of `gcm` is reported
  /// as a problem. Compatible releases work together, but the limits of the older release may
  /// explain a problem.
  void AddVersion(const std::string& what, const Result<tendon::message::ProgramVersion>& reported,
                  const std::string& text, const std::string& fix) {
    const auto [version, is_own] = tendon::CompareVersion(reported, own_);
    if (is_own) {
      Good(what, text + ", " + version);
    } else {
      Bad(what, text + ", " + version, fix);
    }
  }
  /// Returns ", cpu 12.5 %, memory 34.1 MiB"; empty if unknown.
  [[nodiscard]] std::string UsageText(const tendon::ProcessDescription& process) const {
    const auto* health = FindHealth(health_, process);
    if (health == nullptr) return "";
    return ", cpu " + tendon::CpuText(health) + ", memory " + tendon::MemoryText(health);
  }
  /// Returns ", clock 0.0 ms off (+-0.1 ms)"; empty if no table of the process shows the offset of
  /// its clock.
  static std::string ClockText(tendon::GcmClient& client, const tendon::ProcessEntry& entry) {
    for (const auto& [name, component] : entry.components) {
      if (component.tables.empty() || component.tables[0].columns.empty()) continue;
      const auto listener = std::make_shared<ClockListener>();
      const auto& table = component.tables[0];
      const auto id = client.telemetry().Subscribe(
          {entry.process.name, name, table.name, {table.columns[0].name}}, listener);
      const auto deadline = std::chrono::steady_clock::now() + 1s;
      while (!listener->clock() && std::chrono::steady_clock::now() < deadline) {
        std::this_thread::sleep_for(5ms);
      }
      client.telemetry().Unsubscribe(id);
      const auto clock = listener->clock();
      if (!clock) continue;
      return ", clock " + tendon::MillisecondsText(clock->offset) + " off (+-" +
             tendon::MillisecondsText(clock->uncertainty) + ")";
    }
    return "";
  }
  /// Returns the plug-ins with the present state of their files. If the process does not answer,
  /// returns the plug-ins in the catalogue.
  std::vector<tendon::PluginDescription> AskForPlugins(const tendon::ProcessDescription& process) {
    const auto known = AskClasses(context_, process.name);
    return known ? known->loaded : process.plugins;
  }
  /// Checks whether the files of the plug-ins contain the code that the process runs. If `answers`
  /// is false, `plugins` comes from the last report of the process.
  void ExaminePlugins(const std::string& process,
                      const std::vector<tendon::PluginDescription>& plugins, bool answers) {
    for (const tendon::PluginDescription& plugin : plugins) {
      const std::string what = "plug-in " + process + " " + plugin.name;
      if (const auto old = FindOutdatedPlugin(process, plugin)) {
        Bad(what, old->finding, old->remedy);
      } else if (answers) {
        Good(what, PluginText(plugin));
      } else {
        findings_.push_back({what, Finding::Verdict::kUnknown,
                             PluginText(plugin) + ", according to the last report of the process"});
      }
    }
  }
  void ExamineComponents(const tendon::ProcessEntry& entry) {
    for (const auto& [name, component] : entry.components) {
      const std::string path = entry.process.name + "/" + name;
      const auto waits = WaitsOf(entry, component);
      if (waits.empty()) continue;
      const std::string verb = waits.front().has_connection ? "gcm explain " : "gcm candidates ";
      Bad("component " + path, WaitingReasons(waits), verb + path + "/" + waits.front().interface);
    }
  }
  void ExamineConnections(const tendon::Catalogue& catalogue) {
    std::size_t active = 0;
    for (const auto& connection : catalogue.connections()) {
      if (connection.state == tendon::ConnectionState::kActive) {
        ++active;
        continue;
      }
      Bad("connection " + ToString(connection.required),
          std::string(ToString(connection.state)) + ": " + connection.reason,
          "gcm explain " + ToString(connection.required));
    }
    if (active > 0) Good("connections", std::to_string(active) + " active");
  }

  Context& context_;
  const tendon::message::ProgramVersion own_ = tendon::OwnVersion();
  tendon::message::SystemHealth health_;
  Findings findings_;
};

const char* WordOf(Finding::Verdict verdict) {
  return verdict == Finding::Verdict::kGood  ? "ok"
         : verdict == Finding::Verdict::kBad ? "BAD"
                                             : "-";
}

void Print(Context& context, const Findings& findings) {
  if (context.settings().json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const auto& [what, verdict, text, fix] : findings) {
      const char* word = verdict == Finding::Verdict::kGood  ? "good"
                         : verdict == Finding::Verdict::kBad ? "bad"
                                                             : "unknown";
      all.push_back({{"what", what}, {"verdict", word}, {"text", text}, {"fix", fix}});
    }
    context.PrintJson({{"findings", std::move(all)}});
    return;
  }
  std::size_t widest = 0;
  for (const Finding& finding : findings) widest = std::max(widest, finding.what.size());
  const bool is_coloured = context.layout().is_coloured;
  for (const auto& [what, verdict, text, fix] : findings) {
    const std::string word = WordOf(verdict);
    context.out() << Coloured(word, is_coloured) << std::string(5 - word.size(), ' ') << Plain(what)
                  << std::string(widest - what.size() + 2, ' ') << Plain(text) << '\n';
    if (!fix.empty())
      context.out() << std::string(widest + 7, ' ') << "fix: " << Plain(fix) << '\n';
  }
}

Result<ExitCode> Examine(Context& context) {
  const Findings findings = Doctor(context).Examine();
  Print(context, findings);
  const bool is_bad = std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.verdict == Finding::Verdict::kBad;
  });
  return is_bad ? program::kRefused : program::kOk;
}

}  // namespace

std::vector<Verb> DoctorVerbs() {
  return {{"doctor",
           "look for problems with keys, addresses, versions, processes, plug-ins, clocks and "
           "connections",
           [](CLI::App&) -> Verb::Run { return &Examine; }}};
}

}  // namespace console
