#include <tendon/interface/compatibility.h>
#include <tendon/interface/connection.h>

#include <thread>

namespace tendon {
namespace {

/// Waits until the mailbox is empty, its component has stopped executing, or time is up.
void LetDrain(const Mailbox* mailbox, std::chrono::steady_clock::time_point deadline) {
  using namespace std::chrono_literals;
  while (mailbox != nullptr && mailbox->size() > 0 && mailbox->accepting() &&
         std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(200us);
  }
}

}  // namespace

Result<std::unique_ptr<Connection>> Connection::Make(RequiredInterface& required,
                                                     ProvidedInterface& provided,
                                                     const std::string& required_name,
                                                     const std::string& provided_name) {
  if (required.is_connected()) {
    return Error{ErrorCode::kExists, required_name + " is connected already; disconnect it first"};
  }
  const Compatibility compatibility = Compare(required.description(), provided.description());
  if (!compatibility.fits()) {
    return Error{ErrorCode::kIncompatible, Refusal(required_name, provided_name, compatibility)};
  }
  std::unique_ptr<Connection> connection(new Connection(required, provided));
  connection->OpenMailboxes();
  connection->BindHandlers();
  connection->BindFunctions();
  return connection;
}

Connection::Connection(RequiredInterface& required, ProvidedInterface& provided)
    : required_(required), provided_(provided) {}

Connection::~Connection() { Close(std::chrono::milliseconds(0)); }

void Connection::OpenMailboxes() {
  Mailbox::SlotShape command_shape;
  for (const auto& one : required_.callers_) {
    const Offer* offer = provided_.FindCommand(one.description.name);
    if (offer != nullptr) command_shape.Cover(offer->shape());
  }
  Mailbox::SlotShape event_shape;
  for (const auto& handler : required_.handlers_) event_shape.Cover(handler->shape());
  const std::size_t capacity = required_.mailbox_capacity();
  if (provided_.inbox() != nullptr) commands_ = &provided_.inbox()->Open(capacity, command_shape);
  if (required_.inbox() != nullptr && !required_.handlers_.empty()) {
    events_ = &required_.inbox()->Open(capacity, event_shape);
  }
  open_ = true;
}

void Connection::BindHandlers() {
  for (const auto& handler : required_.handlers_) {
    EventBase* event = provided_.FindEvent(handler->description().name);
    if (event == nullptr) continue;  // an optional one
    owned_.push_back(handler->Bind(events_));
    subscriptions_.push_back({event, owned_.back().get()});
    event->Subscribe(*owned_.back());
  }
}

void Connection::BindFunctions() {
  for (const auto& one : required_.callers_) {
    const Offer* offer = provided_.FindCommand(one.description.name);
    if (offer == nullptr) {  // an optional one
      binding_.commands.push_back(nullptr);
      continue;
    }
    owned_.push_back(offer->Bind(commands_));
    CommandBase* command = owned_.back().get();
    if (auto adapter = one.caller->Adapt(*command)) {
      owned_.push_back(std::move(adapter));
      command = owned_.back().get();
    }
    binding_.commands.push_back(command);
  }
  required_.binding_.Exchange(&binding_);
}

std::size_t Connection::Close(std::chrono::milliseconds patience) {
  if (!open_) return 0;
  open_ = false;
  required_.binding_.Exchange(nullptr);
  for (const Subscription& one : subscriptions_) one.event->Unsubscribe(*one.handler);
  const auto deadline = std::chrono::steady_clock::now() + patience;
  LetDrain(commands_, deadline);
  LetDrain(events_, deadline);
  std::size_t dropped = 0;
  if (commands_ != nullptr) dropped += provided_.inbox()->Remove(*commands_);
  if (events_ != nullptr) dropped += required_.inbox()->Remove(*events_);
  commands_ = nullptr;
  events_ = nullptr;
  owned_.clear();
  return dropped;
}

std::size_t Connection::waiting() const { return commands_ != nullptr ? commands_->size() : 0; }

std::uint64_t Connection::refused() const {
  return commands_ != nullptr ? commands_->refused() : 0;
}

}  // namespace tendon
