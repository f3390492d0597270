#include <gcm_console/catalogue/event_choice.h>
#include <gcm_console/catalogue/path_target.h>
#include <gcm_console/feeds/event_inbox.h>
#include <gcm_console/output/table.h>
#include <gcm_console/verbs/common_options.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/base/os/termination.h>
#include <tendon/base/text.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/text.h>
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
  std::uint64_t count = 0;  // number of events; 0: no limit
  double seconds = 0.0;     // 0: no limit
  bool ends_with_link = false;
};

/// Prints events when they arrive, on a terminal with titles. Prints at most `count` events; 0
/// means no limit.
class EventWriter {
 public:
  EventWriter(Context& context, tendon::GcmClient& client, std::uint64_t count)
      : context_(context), client_(client), count_(count) {
    const bool has_titles = context.columns() > 0 && context.settings().titles;
    if (!has_titles || context.settings().json) return;
    context.out() << "TIME                   \tEVENT\tVALUE\n";  // as wide as a time
  }

  /// Requests unknown types as soon as events are subscribed, while the process can still answer.
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

  /// Prints the events, and the losses between them, until the requested number is printed. After a
  /// signal, returns false: the remaining events are not printed, and their losses are not counted.
  bool Write(const EventInbox::Content& content) {
    for (const auto& [event, lost_before] : content.events) {
      if (is_full()) return true;
      WriteLost(lost_before);
      Write(event);
      if (tendon::os::TerminationRequested(0ms)) return false;
    }
    if (!is_full()) WriteLost(content.lost);
    return true;
  }
  /// True if the requested number of events was printed.
  [[nodiscard]] bool is_full() const { return count_ > 0 && printed_ >= count_; }
  [[nodiscard]] std::uint64_t printed() const { return printed_; }
  [[nodiscard]] std::uint64_t lost() const { return lost_; }

 private:
  void WriteLost(const LostEvents& events) {
    for (const auto& [path, lost] : events.by_path) {
      context_.err() << "gcm: " << lost << " events of " << Plain(path)
                     << " are lost, because the events came faster than gcm could read them\n";
      if (context_.settings().json) {
        context_.PrintJsonLine({{"gap", {{"path", path}, {"lost", lost}}}});
      }
      lost_ += lost;
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
  static nlohmann::ordered_json UncertaintyOf(const ReceivedEvent& event) {
    if (event.uncertainty_ns < 0) return nullptr;
    return event.uncertainty_ns;
  }
  /// Returns the value as JSON; "null" if the event has no value or its type is unknown.
  [[nodiscard]] std::string ValueOf(const ReceivedEvent& event) const {
    const auto schema = schemas_.find(event.description.signature.in);
    if (schema == schemas_.end()) return "null";
    const auto json = tendon::ToJson(schema->second, event.value);
    return json ? *json : "null";
  }

  Context& context_;
  tendon::GcmClient& client_;
  std::map<tendon::Fingerprint, tendon::Schema> schemas_;
  const std::uint64_t count_;  // number of events; 0: no limit
  std::uint64_t printed_ = 0;
  std::uint64_t lost_ = 0;
};

/// Subscribes to all events that match, including events that are added later.
class EventListeners {
 public:
  EventListeners(tendon::GcmClient& client, const std::shared_ptr<EventInbox>& inbox)
      : client_(client), inbox_(inbox) {}
  EventListeners(const EventListeners&) = delete;
  EventListeners& operator=(const EventListeners&) = delete;
  ~EventListeners() {
    for (const auto& [provided, listener] : listeners_) client_.StopListening(listener.id);
  }

  void Follow(const std::vector<std::string>& patterns) {
    for (const auto& wanted : MatchingEvents(client_.catalogue(), patterns)) {
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

void ReportBegun(const EventInbox::Content& content, Context& context) {
  for (const tendon::EventSubscription& one : content.begun) {
    context.err() << "gcm: listening to "
                  << tendon::Counted(one.events.size(), "event of ", "events of ")
                  << Plain(ToString(one.provided)) << '\n';
  }
}

void Complain(const EventInbox::Content& content, Context& context) {
  for (const Error& complaint : content.complaints) {
    context.err() << "gcm: " << Plain(complaint.message) << '\n';
  }
  if (content.is_gcm_back) context.PrintGcmReturn();
}

Result<ExitCode> PrintEvents(Context& context, const EventsOptions& options) {
  tendon::os::HoldTerminationSignals();
  const auto inbox = std::make_shared<EventInbox>();
  const auto client = context.Client(inbox);
  if (!client) return client.error();
  const auto good = CheckEventPatterns((*client)->catalogue(), options.patterns);
  if (!good) return good.error();

  EventWriter writer(context, **client, options.count);
  EventListeners listeners(**client, inbox);
  listeners.Follow(options.patterns);
  const auto begin = std::chrono::steady_clock::now();
  bool is_interrupted = false;
  std::optional<Error> broken;
  const auto wants_more = [&] {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    return !is_interrupted && !broken && context.out().good() && !writer.is_full() &&
           (options.seconds == 0.0 || passed.count() < options.seconds);
  };
  bool has_more = false;
  while (wants_more()) {
    is_interrupted = tendon::os::TerminationRequested(has_more ? 0ms : 20ms);
    const EventInbox::Content content = inbox->Take();
    has_more = content.has_more;
    if (content.is_catalog_new) listeners.Follow(options.patterns);
    writer.Learn(content);
    ReportBegun(content, context);
    is_interrupted = is_interrupted || !writer.Write(content);
    context.out().flush();
    if (options.ends_with_link && !content.complaints.empty()) {
      broken = content.complaints.front();  // it is reported at the end
    } else {
      Complain(content, context);
    }
  }
  context.err() << "gcm: " << tendon::Counted(writer.printed(), "event", "events") << ", "
                << writer.lost() << " lost\n";
  if (broken) return *broken;
  return is_interrupted ? program::kInterrupted : program::kOk;
}

Verb::Run PrepareEvents(CLI::App& app) {
  auto options = std::make_shared<EventsOptions>();
  WithKind(app.add_option("paths", options->patterns,
                          "events or provided interfaces; a pattern with * or ** matches several"),
           WordKind::kEvent)
      ->required();
  AddCount(app, options->count, "end after this many events");
  AddDuration(app, options->seconds);
  AddNoReconnect(app, options->ends_with_link);
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
