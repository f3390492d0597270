#include <tendon/interface/connection.h>

#include <tendon/interface/compatibility.h>

#include <algorithm>
#include <optional>
#include <thread>
#include <utility>

namespace tendon {
namespace {

/// The time within which a running handler must return.
constexpr std::chrono::milliseconds kGrace(100);

/// Waits until the mailbox is empty, its component has stopped executing calls, or the deadline has
/// passed.
void LetDrain(const Mailbox* mailbox, std::chrono::steady_clock::time_point deadline) {
  using namespace std::chrono_literals;
  while (mailbox != nullptr && mailbox->size() > 0 && mailbox->accepting() &&
         std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(200us);
  }
}

/// Returns the function with which the calling thread would wait for itself; empty if no function
/// does.
std::optional<std::string> WaitForItself(const RequiredInterface& required,
                                         const ProvidedInterface& provided) {
  if (required.inbox() == nullptr || required.inbox() != provided.inbox()) return std::nullopt;
  for (const MemberDescription& function : required.description().functions) {
    const CommandKind kind = function.signature.kind;
    if (WaitsForServer(kind) && provided.FindCommand(function.name) != nullptr) {
      return std::string(ToString(kind)) + " command '" + function.name + "'";
    }
  }
  return std::nullopt;
}

}  // namespace

Error AlreadyConnected(const std::string& required_name) {
  return {ErrorCode::kExists, required_name + " is already connected; end that connection first"};
}

Result<std::unique_ptr<Connection>> Connection::Make(RequiredInterface& required,
                                                     ProvidedInterface& provided,
                                                     const std::string& required_name,
                                                     const std::string& provided_name) {
  if (required.is_connected()) return AlreadyConnected(required_name);
  const Compatibility compatibility = Compare(
      required.description(),
      required.observes_calls() ? provided.description_for_observers() : provided.description());
  if (!compatibility.fits()) {
    return Error{ErrorCode::kIncompatible, Refusal(required_name, provided_name, compatibility)};
  }
  if (const auto waiting = WaitForItself(required, provided)) {
    return Error{ErrorCode::kIncompatible,
                 required_name + " would wait for its own thread: " + *waiting + " of " +
                     provided_name +
                     " is executed by the task that calls it; call the method directly"};
  }
  std::unique_ptr<Connection> connection(new Connection(required, provided, required_name));
  connection->OpenMailboxes();
  connection->BindFunctions();
  if (connection->is_notified_here()) {
    required.Announce(connection->peer_);
    connection->BindHandlers();
    required.AdmitPeer();
  } else {
    connection->BindHandlers();
    required.Announce(connection->peer_);
  }
  return connection;
}

Connection::Connection(RequiredInterface& required, ProvidedInterface& provided, std::string client)
    : required_(required),
      provided_(provided),
      client_(std::make_shared<const std::string>(std::move(client))),
      lost_before_(required.lost_events()) {}

Connection::~Connection() { Close(std::chrono::milliseconds(0)); }

Mailbox::SlotShape Connection::CommandShape(const RequiredInterface& required,
                                            const ProvidedInterface& provided) {
  Mailbox::SlotShape shape;
  for (const auto& one : required.callers_) {
    const Offer* offer = provided.FindCommand(one.description.name);
    if (offer != nullptr) shape.Cover(offer->shape());
  }
  return shape;
}

Mailbox::SlotShape Connection::EventShape(const RequiredInterface& required) {
  Mailbox::SlotShape shape;
  for (const auto& handler : required.handlers_) shape.Cover(handler->shape());
  return shape;
}

std::size_t Connection::MailboxBytes(const RequiredInterface& required,
                                     const ProvidedInterface& provided) {
  return required.mailbox_capacity() *
         (Mailbox::SlotBytes(CommandShape(required, provided), Mailbox::kEntryBytes) +
          Mailbox::SlotBytes(EventShape(required), Mailbox::kTimedEntryBytes));
}

void Connection::OpenMailboxes() {
  open_ = true;
  const Mailbox::SlotShape command_shape = CommandShape(required_, provided_);
  const Mailbox::SlotShape event_shape = EventShape(required_);
  const std::size_t capacity = required_.mailbox_capacity();
  if (provided_.inbox() != nullptr) {
    commands_ = &provided_.inbox()->Open(capacity, command_shape, required_.callers());
  }
  if (required_.inbox() != nullptr && !required_.handlers_.empty()) {
    // If a call is refused, its caller reports the call to the observers, so several threads raise
    // this event.
    const bool shows_calls = std::ranges::any_of(required_.handlers_, [this](const auto& handler) {
      return provided_.FindEvent(handler->description().name) == nullptr;
    });
    const CallerThreads raisers = required_.observes_calls() && shows_calls
                                      ? CallerThreads::kManyThreads
                                      : provided_.raisers();
    events_ = &required_.inbox()->Open(capacity, event_shape, raisers, &required_.event_time_);
    if (required_.has_listener()) events_->Hold();  // until OnConnected() has returned
    peer_.events = events_;
  }
}

void Connection::BindHandlers() {
  for (const auto& handler : required_.handlers_) {
    const std::string& name = handler->description().name;
    EventBase* event = provided_.FindEvent(name);
    if (event == nullptr && required_.observes_calls()) event = provided_.ObserveCalls(name);
    if (event == nullptr) continue;  // optional, and not offered
    Commands& kept = handler->uses_mailbox() ? queued_handlers_ : direct_handlers_;
    kept.push_back(handler->Bind(events_));
    CommandBase& bound = *kept.back();
    subscriptions_.push_back({event, &bound});
    event->Subscribe(bound, &required_.lost_events_);
    if (provided_.component() != nullptr && provided_.component()->is_faulted())
      bound.SetSourceFaulted(true);
  }
}

void Connection::BindFunctions() {
  members_.reserve(required_.callers_.size() + 1);
  for (const auto& one : required_.callers_) {
    const Offer* offer = provided_.FindCommand(one.description.name);
    if (offer == nullptr) {  // optional, and not offered
      members_.emplace_back();
      continue;
    }
    functions_.push_back(offer->Bind(commands_));
    functions_.back()->SetClient(client_);
    CommandBase* command = functions_.back().get();
    if (auto adapter = one.caller->Adapt(*command)) {
      functions_.push_back(std::move(adapter));
      command = functions_.back().get();
      converted_.push_back(one.description.name);
    }
    members_.push_back({command, &offer->enabled(), provided_.component()});
  }
  members_.emplace_back();
  peer_.members = members_.data();
}

std::size_t Connection::Close(std::chrono::milliseconds timeout) {
  if (!open_) return 0;
  open_ = false;
  if (is_notified_here()) required_.AnnounceNone();
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  if (commands_ != nullptr) {
    // A caller that waits uses the binding. Therefore, all calls with waiting callers are executed
    // or cancelled before the binding is destroyed.
    commands_->Close();
    LetDrain(commands_, deadline);
    commands_->completions().Cancel();
  }
  required_.Withdraw();
  for (const Subscription& one : subscriptions_) one.event->Unsubscribe(*one.handler);
  LetDrain(commands_, deadline);  // calls that were posted during Close()
  if (events_ != nullptr && !events_->is_held()) LetDrain(events_, deadline);
  const auto last = std::max(deadline, std::chrono::steady_clock::now() + kGrace);
  const std::uint64_t number = commands_ != nullptr ? commands_->number() : 0;
  std::size_t dropped = 0;
  if (commands_ != nullptr) {
    dropped += provided_.inbox()->Remove(*commands_, std::move(functions_), last);
  }
  if (events_ != nullptr) {
    dropped += required_.inbox()->Remove(*events_, std::move(queued_handlers_), last);
  }
  commands_ = nullptr;
  events_ = nullptr;
  functions_.clear();
  queued_handlers_.clear();
  direct_handlers_.clear();
  if (!is_notified_here()) required_.AnnounceNone();  // after the last event was handled
  ReportClientGone(number);
  return dropped;
}

void Connection::ReportClientGone(std::uint64_t number) {
  const bool has_called = std::ranges::any_of(
      members_, [](const BoundMember& member) { return member.command != nullptr; });
  const ComponentAccess* const component = provided_.component();
  if (!has_called || component == nullptr || !component->is_notified_of_connections()) return;
  component->ReportClientGone({.provided = &provided_, .name = *client_, .connection = number});
}

std::uint64_t Connection::taken() const {
  const std::uint64_t calls = commands_ != nullptr ? commands_->taken() : 0;
  return calls + (events_ != nullptr ? events_->taken() : 0);
}

std::size_t Connection::capacity() const {
  return commands_ != nullptr ? commands_->capacity() : 0;
}

std::size_t Connection::waiting() const { return commands_ != nullptr ? commands_->size() : 0; }

std::uint64_t Connection::refused() const {
  return commands_ != nullptr ? commands_->refused() : 0;
}

std::uint64_t Connection::replaced() const {
  return commands_ != nullptr ? commands_->replaced() : 0;
}

std::uint64_t Connection::lost_events() const { return required_.lost_events() - lost_before_; }

}  // namespace tendon
