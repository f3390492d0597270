#include <gcm_console/feeds/event_inbox.h>
#include <gtest/gtest.h>
#include <tendon/base/clock.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <string>

namespace console {
namespace {

using Lost = std::map<std::string, std::uint64_t>;

/// Listens to two events of one interface.
class EventInboxTest : public testing::Test {
 protected:
  EventInboxTest() { sink->OnListening({{.name = "Cried"}, {.name = "Fell"}}); }

  void Raise(std::size_t event) const {
    sink->OnEvent(event, {}, {.raised = tendon::SteadyClock().Now()});
  }

  const std::shared_ptr<EventInbox> inbox = std::make_shared<EventInbox>();
  const std::shared_ptr<tendon::EventSink> sink =
      inbox->SinkOf({.provided = {"hall", "crier", "Voice"}, .events = {"Cried", "Fell"}});
  const std::string cried = "hall/crier/Voice.Cried";
  const std::string fell = "hall/crier/Voice.Fell";
};

TEST_F(EventInboxTest, ALossKeepsItsPlaceBetweenEvents) {
  Raise(0);
  sink->OnEventsLost(0, 2);
  sink->OnEventsLost(1, 1);
  sink->OnEventsLost(0, 3);
  Raise(1);
  sink->OnEventsLost(1, 4);

  const EventInbox::Content content = inbox->Take();

  ASSERT_EQ(content.events.size(), 2U);
  EXPECT_EQ(content.events[0].element.path, cried);
  EXPECT_EQ(content.events[0].lost_before.by_path, Lost());
  EXPECT_EQ(content.events[1].element.path, fell);
  EXPECT_EQ(content.events[1].lost_before.by_path, (Lost{{cried, 5}, {fell, 1}}));
  EXPECT_EQ(content.lost.by_path, (Lost{{fell, 4}}));
  EXPECT_EQ(inbox->Take().lost.by_path, Lost());
}

TEST_F(EventInboxTest, DroppedEventsCountAsLostBeforeTheOldestKept) {
  constexpr std::uint64_t kTooMany = 5;
  const std::uint64_t room =
      std::min(kMaxWaiting.elements, kMaxWaiting.bytes / sizeof(EventInbox::Events::Entry));
  Raise(1);
  for (std::uint64_t i = 1; i < room + kTooMany; ++i) Raise(0);
  sink->OnEventsLost(1, 7);

  EventInbox::Content content = inbox->Take();

  EXPECT_EQ(content.events.front().lost_before.by_path, (Lost{{cried, kTooMany - 1}, {fell, 1}}));
  EXPECT_EQ(content.lost.by_path, Lost()) << "older events wait";
  while (content.has_more) content = inbox->Take();
  EXPECT_EQ(content.lost.by_path, (Lost{{fell, 7}}));
}

}  // namespace
}  // namespace console
