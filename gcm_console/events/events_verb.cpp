#include <gcm_console/events/event_choice.h>
#include <gcm_console/events/event_inbox.h>
#include <gcm_console/place.h>
#include <gcm_console/report.h>
#include <gcm_console/verb.h>
#include <program/command_line.h>
#include <tendon/base/counted.h>
#include <tendon/base/os/termination.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/text/wall_time.h>
#include <tendon/payload/json.h>
#include <tendon/payload/json/strict_json.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace console {
namespace {

using namespace std::chrono_literals;

struct EventsOptions {
  std::vector<std::string> patterns;
  std::uint64_t count = 0;  // events, 0: no end
  double seconds = 0.0;     // 0: no end
  bool ends_with_link = false;
};

/// Prints events as they come; on a terminal with titles.
class EventWriter {
 public:
  EventWriter(Context& context, tendon::GcmClient& client) : context_(context), client_(client) {
    const bool has_titles = context.columns() > 0 && context.settings().titles;
    if (!has_titles || context.settings().json) return;
    context.out() << "TIME                   \tEVENT\tVALUE\n";  // as wide as a time
  }

  /// Requests unknown types while the process can still answer.
  void Learn(const EventInbox::Content& content) {
    std::size_t next = 0;
    for (const tendon::EventSubscription& one : content.begun) {
      for (std::size_t i = 0; i < one.events.size(); ++i, ++next) {
        const auto& event = content.descriptions.at(next);
        const tendon::Fingerprint type = event.signature.in;
        if (!TakesArgument(event.signature) || schemas_.contains(type)) continue;
        auto schema = tendon::Wait<tendon::Schema>(context_.settings().timeout, [&](auto handler) {
          client_.GetSchema(one.provided.process, type, handler);
        });
        if (schema) {
          schemas_.emplace(type, *std::move(schema));
        } else {
          context_.err() << "gcm: values of " << Plain(event.in_type)
                         << " cannot be shown: " << Plain(schema.error().message) << '\n';
        }
      }
    }
  }

  void Write(const ReceivedEvent& event) {
    ++printed_;
    const std::string value = ValueOf(event);
    if (context_.settings().json) {
      return context_.PrintJsonLine({{"time_ns", event.time_ns},
                                     {"uncertainty_ns", UncertaintyOf(event)},
                                     {"path", event.path},
                                     {"value", tendon::JsonOrText(value)}});
    }
    context_.out() << tendon::FineWallTimeText(event.time_ns) << '\t' << Plain(event.path) << '\t'
                   << (TakesArgument(event.description.signature) ? value : "-") << '\n';
  }
  [[nodiscard]] std::uint64_t printed() const { return printed_; }

 private:
  static nlohmann::ordered_json UncertaintyOf(const ReceivedEvent& event) {
    if (event.uncertainty_ns < 0) return nullptr;
    return event.uncertainty_ns;
  }
  /// As JSON; "null" if the event has no value or its type is unknown.
  [[nodiscard]] std::string ValueOf(const ReceivedEvent& event) const {
    const auto schema = schemas_.find(event.description.signature.in);
    if (schema == schemas_.end()) return "null";
    const auto json = tendon::ToJson(schema->second, event.value);
    return json ? *json : "null";
  }

  Context& context_;
  tendon::GcmClient& client_;
  std::map<tendon::Fingerprint, tendon::Schema> schemas_;
  std::uint64_t printed_ = 0;
};

/// Listens to all events that match, including later ones.
class Listeners {
 public:
  Listeners(tendon::GcmClient& client, const std::shared_ptr<EventInbox>& inbox)
      : client_(client), inbox_(inbox) {}
  Listeners(const Listeners&) = delete;
  Listeners& operator=(const Listeners&) = delete;
  ~Listeners() {
    for (const auto& [provided, listener] : listeners_) client_.StopListening(listener.id);
  }

  void Follow(const std::vector<std::string>& patterns) {
    for (const auto& wanted : EventsThatFit(client_.catalogue(), patterns)) {
      const auto known = listeners_.find(wanted.provided);
      if (known != listeners_.end()) {
        if (known->second.events == wanted.events) continue;
        client_.StopListening(known->second.id);
      }
      listeners_[wanted.provided] = {.events = wanted.events,
                                     .id = client_.Listen(wanted, inbox_->SinkOf(wanted))};
    }
  }

 private:
  struct Listener {
    std::vector<std::string> events;
    tendon::GcmClient::ListenerId id = 0;
  };

  tendon::GcmClient& client_;
  const std::shared_ptr<EventInbox> inbox_;
  std::map<tendon::InterfaceName, Listener> listeners_;
};

/// Prints the remarks of `content`; returns the number of lost events.
std::uint64_t Remark(const EventInbox::Content& content, Context& context) {
  std::ostream& err = context.err();
  for (const tendon::EventSubscription& one : content.begun) {
    err << "gcm: listening to " << tendon::Counted(one.events.size(), "event of ", "events of ")
        << Plain(ToString(one.provided)) << '\n';
  }
  std::uint64_t all = 0;
  for (const auto& [path, lost] : content.lost) {
    err << "gcm: lost " << lost << " of " << Plain(path)
        << ": they came faster than they were read\n";
    if (context.settings().json) {
      context.PrintJsonLine({{"gap", {{"path", path}, {"lost", lost}}}});
    }
    all += lost;
  }
  return all;
}

void Complain(const EventInbox::Content& content, Context& context) {
  for (const Error& complaint : content.complaints) {
    context.err() << "gcm: " << Plain(complaint.message) << '\n';
  }
  if (content.is_gcm_back) {
    context.err() << "gcm: the GCM at " << Plain(context.settings().gcm) << " is there again\n";
  }
}

Result<ExitCode> PrintEvents(Context& context, const EventsOptions& options) {
  tendon::os::HoldTerminationSignals();
  const auto inbox = std::make_shared<EventInbox>();
  const auto client = context.Client(inbox);
  if (!client) return client.error();
  const auto good = CheckEventPatterns((*client)->catalogue(), options.patterns);
  if (!good) return good.error();

  EventWriter writer(context, **client);
  Listeners listeners(**client, inbox);
  listeners.Follow(options.patterns);
  const auto begin = std::chrono::steady_clock::now();
  std::uint64_t lost = 0;
  bool is_interrupted = false;
  std::optional<Error> broken;
  const auto wants_more = [&] {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    return !is_interrupted && !broken && context.out().good() &&
           (options.count == 0 || writer.printed() < options.count) &&
           (options.seconds == 0.0 || passed.count() < options.seconds);
  };
  bool has_more = false;
  while (wants_more()) {
    is_interrupted = tendon::os::TerminationAsked(has_more ? 0ms : 20ms);
    const EventInbox::Content content = inbox->Take();
    has_more = content.has_more;
    if (content.is_catalog_new) listeners.Follow(options.patterns);
    writer.Learn(content);
    for (const ReceivedEvent& event : content.events) {
      if (is_interrupted || (options.count > 0 && writer.printed() == options.count)) break;
      writer.Write(event);
      is_interrupted = tendon::os::TerminationAsked(0ms);
    }
    lost += Remark(content, context);
    context.out().flush();
    if (options.ends_with_link && !content.complaints.empty()) {
      broken = content.complaints.front();  // reported at the end
    } else {
      Complain(content, context);
    }
  }
  context.err() << "gcm: " << tendon::Counted(writer.printed(), "event", "events") << ", " << lost
                << " lost\n";
  if (broken) return *broken;
  return is_interrupted ? program::kInterrupted : program::kOk;
}

Verb::Run PrepareEvents(CLI::App& app) {
  auto options = std::make_shared<EventsOptions>();
  Names(app.add_option("paths", options->patterns,
                       "events or provided interfaces, with * and ** for several"),
        WordKind::kEvent)
      ->required();
  app.add_option("--count", options->count, "end after so many events")
      ->transform(CLI::Validator(&program::TransformCount, ""));
  app.add_option("--for", options->seconds, "end after so long: 10s, 500ms, 2min")
      ->type_name("TIME")
      ->transform(CLI::Validator(&program::TransformDuration, ""));
  app.add_flag("--no-reconnect", options->ends_with_link,
               "end when the GCM or a process is lost, rather than wait for it");
  return [options](Context& context) { return PrintEvents(context, *options); };
}

}  // namespace

std::vector<Verb> EventVerbs() {
  return {{"events",
           "print events as they are raised: time, path, value",
           &PrepareEvents,
           {"gcm events robot/arm/Control", "gcm events 'robot/**' --jsonl --for 10s"}}};
}

}  // namespace console
