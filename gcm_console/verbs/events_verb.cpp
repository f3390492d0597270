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
#include <tendon/interface/observed_call.h>
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
  bool has_commands = false;

  [[nodiscard]] CommandChoice commands() const {
    return has_commands ? CommandChoice::kAll : CommandChoice::kNamed;
  }
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
      for (std::size_t i = 0; i < one.size(); ++i, ++next) {
        const auto& event = content.descriptions.at(next);
        if (TakesArgument(event.signature)) {
          Learn(one.provided.process, event.signature.in, event.in_type);
        }
        if (one.is_command(i)) Learn(one.provided.process, event.signature.out, event.out_type);
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
  void Learn(const std::string& process, tendon::Fingerprint type, const std::string& name) {
    if (schemas_.contains(type)) return;
    auto schema = tendon::Wait<tendon::Schema>(context_.settings().timeout, [&](auto handler) {
      client_.GetSchema(process, type, handler);
    });
    if (schema) {
      schemas_.emplace(type, *std::move(schema));
    } else {
      context_.err() << "gcm: values of " << Plain(name)
                     << " cannot be shown: " << Plain(schema.error().message) << '\n';
    }
  }
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
    context_.out() << tendon::FineWallTimeText(event.time_ns) << '\t' << Plain(event.path) << '\t';
    if (event.is_call) {
      context_.out() << TextOfCall(value) << '\n';
    } else {
      context_.out() << (TakesArgument(event.description.signature) ? value : "-") << '\n';
    }
  }
  /// Returns for example "1.5\trefused (queue_full), from desk/operator/Robot".
  static std::string TextOfCall(const std::string& json) {
    const auto call = nlohmann::ordered_json::parse(json, nullptr, false);
    if (!call.is_object()) return "-";
    const auto text = [&call](const char* key) {
      return call.contains(key) && call[key].is_string() ? call[key].get<std::string>() : "?";
    };
    std::string words = call.contains("argument") ? call["argument"].dump() : "-";
    if (call.contains("result")) words += " -> " + call["result"].dump();
    const std::string outcome = text("outcome");
    const std::string status = text("status");
    words += "\t" + outcome;
    if (status != "done" && status != outcome) words += " (" + status + ")";
    return words + ", from " + Plain(text("client"));
  }
  static nlohmann::ordered_json UncertaintyOf(const ReceivedEvent& event) {
    if (event.uncertainty_ns < 0) return nullptr;
    return event.uncertainty_ns;
  }
  /// Returns the value as JSON; "null" if the event has no value or its type is unknown.
  [[nodiscard]] std::string ValueOf(const ReceivedEvent& event) const {
    const tendon::Signature& signature = event.description.signature;
    const tendon::Schema* argument = Find(signature.in);
    const tendon::Schema* result = Find(signature.out);
    if (!event.is_call && !TakesArgument(signature)) return "null";
    if (argument == nullptr || (event.is_call && result == nullptr)) return "null";
    const auto json = tendon::ToJson(
        event.is_call ? tendon::SchemaOfCalls(*argument, *result) : *argument, event.value);
    return json ? *json : "null";
  }
  /// Null if the type is unknown.
  [[nodiscard]] const tendon::Schema* Find(tendon::Fingerprint type) const {
    const auto schema = schemas_.find(type);
    return schema == schemas_.end() ? nullptr : &schema->second;
  }

  Context& context_;
  tendon::GcmClient& client_;
  std::map<tendon::Fingerprint, tendon::Schema> schemas_ = {
      {tendon::FingerprintOf<tendon::None>(), tendon::Schema()}};
  const std::uint64_t count_;  // number of events; 0: no limit
  std::uint64_t printed_ = 0;
  std::uint64_t lost_ = 0;
};

/// Subscribes to all events and commands that match, including events and commands that are added
/// later.
class EventListeners {
 public:
  EventListeners(tendon::GcmClient& client, const std::shared_ptr<EventInbox>& inbox)
      : client_(client), inbox_(inbox) {}
  EventListeners(const EventListeners&) = delete;
  EventListeners& operator=(const EventListeners&) = delete;
  ~EventListeners() {
    for (const auto& [key, listener] : listeners_) client_.StopListening(listener.id);
  }

  void Follow(const EventsOptions& options) {
    const tendon::Catalogue catalogue = client_.catalogue();
    for (const auto& wanted : MatchingEvents(catalogue, options.patterns)) Follow(wanted);
    for (const auto& wanted : MatchingCommands(catalogue, options.patterns, options.commands())) {
      Follow(wanted);
    }
  }

 private:
  struct Listener {
    tendon::EventSubscription subscription;
    tendon::GcmClient::ListenerId id = 0;
  };

  /// Events and commands of an interface have separate subscriptions.
  void Follow(const tendon::EventSubscription& wanted) {
    const std::pair key(wanted.provided, !wanted.commands.empty());
    const auto known = listeners_.find(key);
    if (known != listeners_.end()) {
      if (known->second.subscription == wanted) return;
      client_.StopListening(known->second.id);
    }
    listeners_[key] = {.subscription = wanted,
                       .id = client_.Listen(wanted, inbox_->SinkOf(wanted))};
  }

  tendon::GcmClient& client_;
  const std::shared_ptr<EventInbox> inbox_;
  std::map<std::pair<tendon::InterfaceName, bool>, Listener> listeners_;
};

void ReportBegun(const EventInbox::Content& content, Context& context) {
  for (const tendon::EventSubscription& one : content.begun) {
    const bool are_commands = !one.commands.empty();
    context.err() << "gcm: listening to "
                  << tendon::Counted(one.size(), are_commands ? "command of " : "event of ",
                                     are_commands ? "commands of " : "events of ")
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
  const auto good =
      CheckEventPatterns((*client)->catalogue(), options.patterns, options.commands());
  if (!good) return good.error();

  EventWriter writer(context, **client, options.count);
  EventListeners listeners(**client, inbox);
  listeners.Follow(options);
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
    if (content.is_catalog_new) listeners.Follow(options);
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
                          "events, commands or provided interfaces; a pattern with * or ** "
                          "matches several events"),
           WordKind::kEvent)
      ->required();
  app.add_flag("--commands", options->has_commands,
               "also print the calls of all commands that match, except reads; without this "
               "option, only the calls of commands whose full path is given");
  AddCount(app, options->count, "end after this many events");
  AddDuration(app, options->seconds);
  AddNoReconnect(app, options->ends_with_link);
  return [options](Context& context) { return PrintEvents(context, *options); };
}

}  // namespace

std::vector<Verb> EventVerbs() {
  return {{"events",
           "print events as they are raised, and calls of commands: time, path, value",
           &PrepareEvents,
           {"gcm events robot/arm/Control", "gcm events robot/arm/Control.MoveTo",
            "gcm events 'robot/**' --commands --jsonl --for 10s"}}};
}

}  // namespace console
