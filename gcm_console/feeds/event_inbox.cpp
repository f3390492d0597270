#include <gcm_console/feeds/event_inbox.h>

#include <tendon/gcm/text.h>
#include <tendon/interface/observed_call.h>

#include <chrono>
#include <utility>

namespace console {

LostEvents& LostEvents::operator+=(const LostEvents& other) {
  for (const auto& [path, lost] : other.by_path) by_path[path] += lost;
  return *this;
}

class EventInbox::Sink final : public tendon::EventSink {
 public:
  Sink(std::shared_ptr<EventInbox> inbox, tendon::EventSubscription subscription)
      : inbox_(std::move(inbox)), subscription_(std::move(subscription)) {}

  void OnListening(const std::vector<tendon::MemberDescription>& events) override {
    events_ = events;
    const std::scoped_lock lock(inbox_->mutex_);
    Content& content = inbox_->content_;
    content.begun.push_back(subscription_);
    content.descriptions.insert(content.descriptions.end(), events.begin(), events.end());
  }
  void OnEvent(std::size_t event, std::span<const std::byte> value,
               const tendon::EventTime& time) override {
    const bool is_call = subscription_.is_command(event);
    const auto took = is_call ? tendon::HeaderOfCall(value).took : std::chrono::nanoseconds(0);
    const std::chrono::nanoseconds age = tendon::SteadyClock().Now() - time.raised + took;
    const std::int64_t raised = tendon::WallTime() - age.count();
    const bool is_known = time.uncertainty != tendon::EventTime().uncertainty;
    const std::scoped_lock lock(inbox_->mutex_);
    inbox_->events_.Push({.time_ns = raised,
                          .uncertainty_ns = is_known ? time.uncertainty.count() : -1,
                          .path = PathOf(event),
                          .description = events_.at(event),
                          .value = {value.begin(), value.end()},
                          .is_call = is_call},
                         sizeof(Events::Entry) + value.size(), [](const ReceivedEvent& oldest) {
                           return LostEvents{{{oldest.path, 1}}};
                         });
  }
  void OnEventsLost(std::size_t event, std::uint64_t lost) override {
    const std::scoped_lock lock(inbox_->mutex_);
    inbox_->events_.AddLost({{{PathOf(event), lost}}});
  }
  void OnStale(const tendon::Error& reason) override {
    const std::scoped_lock lock(inbox_->mutex_);
    inbox_->Complain({tendon::ErrorCode::kFailed, reason.message});
  }

 private:
  [[nodiscard]] std::string PathOf(std::size_t event) const { return subscription_.path(event); }

  const std::shared_ptr<EventInbox> inbox_;
  const tendon::EventSubscription subscription_;
  std::vector<tendon::MemberDescription> events_;
};

std::shared_ptr<tendon::EventSink> EventInbox::SinkOf(
    const tendon::EventSubscription& subscription) {
  return std::make_shared<Sink>(shared_from_this(), subscription);
}

EventInbox::Content EventInbox::Take() {
  const std::scoped_lock lock(mutex_);
  Content content = std::exchange(content_, {});
  content.events = events_.Take();
  content.lost = events_.TakeLost();
  content.has_more = !events_.is_empty();
  return content;
}

/// Stores an error; call it with the lock held. The number of stored errors is limited, because the
/// caller may never take them.
void EventInbox::Complain(const tendon::Error& complaint) {
  constexpr std::size_t kMax = 100;
  if (content_.complaints.size() < kMax) content_.complaints.push_back(complaint);
}

void EventInbox::OnSnapshot(const tendon::Catalogue& /*catalogue*/) {
  const std::scoped_lock lock(mutex_);
  content_.is_catalog_new = true;
  if (std::exchange(is_gcm_lost_, false)) content_.is_gcm_back = true;
}

void EventInbox::OnChanges(const std::vector<tendon::CatalogueChange>& /*changes*/) {
  const std::scoped_lock lock(mutex_);
  content_.is_catalog_new = true;
}

void EventInbox::OnGcmLost(const tendon::Error& reason) {
  const std::scoped_lock lock(mutex_);
  Complain({tendon::ErrorCode::kUnreachable, reason.message});
  is_gcm_lost_ = true;
  content_.is_gcm_back = false;
}

}  // namespace console
