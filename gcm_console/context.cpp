#include <gcm_console/context.h>

#include <tendon/base/os/termination.h>
#include <tendon/base/text.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

namespace console {
namespace {

bool WantsNoColor() {
  const char* no_color = std::getenv("NO_COLOR");  // NOLINT(concurrency-mt-unsafe): read only
  const bool is_set = no_color != nullptr && *no_color != '\0';
  return is_set || IsDumbTerminal();
}

}  // namespace

bool IsDumbTerminal() {
  const char* terminal = std::getenv("TERM");  // NOLINT(concurrency-mt-unsafe): read only
  return terminal == nullptr || *terminal == '\0' || std::string_view(terminal) == "dumb";
}

tendon::Error NoInput(const std::string& verb) {
  return {tendon::ErrorCode::kInvalid,
          "this console has no standard input; use a terminal: gcm " + verb + " -"};
}

Context::Context(Settings settings, std::string verb, const Streams& streams, ShellSession* session)
    : settings_(std::move(settings)),
      verb_(std::move(verb)),
      streams_(streams),
      session_(session) {}

bool Context::has_screen() const {
  return streams_.make_line_reader != nullptr && !IsDumbTerminal();
}

TableLayout Context::layout() const {
  const bool is_usual = columns() > 0 && !WantsNoColor();
  return {.columns = columns(),
          .is_coloured = settings_.color == ColorChoice::kAlways ||
                         (settings_.color == ColorChoice::kAuto && is_usual),
          .has_titles = settings_.titles};
}

tendon::Result<tendon::GcmClient*> Context::Client(std::shared_ptr<tendon::GcmListener> listener) {
  if (client_) return client_.get();
  const auto begin = std::chrono::steady_clock::now();
  const bool is_shared = session_ != nullptr && !listener && session_->Fits(settings_);
  auto client =
      is_shared ? session_->Client() : OpenClient(settings_, "gcm " + verb_, std::move(listener));
  if (!client) return client.error();
  std::optional<tendon::os::TerminationUnblockScope> impatient;
  if (session_ == nullptr) impatient.emplace();
  if (auto watching = (*client)->WaitUntilWatching(); !watching) return watching.error();
  client_ = *std::move(client);
  if (settings_.verbosity == Verbosity::kVerbose) {
    const auto passed = std::chrono::duration_cast<std::chrono::milliseconds>(
        std::chrono::steady_clock::now() - begin);
    const tendon::Catalogue catalogue = client_->catalogue();
    err() << "gcm: GCM at " << Plain(settings_.gcm) << " answered within " << passed.count()
          << " ms: " << tendon::Counted(catalogue.processes().size(), "process", "processes")
          << ", revision " << catalogue.revision() << '\n';
  }
  return client_.get();
}

void Context::PrintGcmReturn() {
  err() << "gcm: the GCM at " << Plain(settings_.gcm) << " is available again\n";
}

void Context::PrintJson(const nlohmann::ordered_json& content) const {
  nlohmann::ordered_json document = {{"schema", 1}};
  document.update(content);
  out() << document.dump(2) << '\n';
}

void Context::PrintJsonLine(const nlohmann::ordered_json& content) const {
  nlohmann::ordered_json document = {{"schema", 1}};
  document.update(content);
  out() << document.dump() << '\n';
}

}  // namespace console
