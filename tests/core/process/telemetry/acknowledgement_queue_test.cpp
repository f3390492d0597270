#include <tendon/process/telemetry/telemetry_server.h>

#include "core/process/telemetry/recording_handler.h"
#include "support/wait.h"

namespace tendon {
namespace {

TEST(AcknowledgementQueue, ReturnsEachOnce) {
  const ProcessAndViewer ends;
  AcknowledgementQueue box;
  box.Add(ends.channel, 1);
  box.Add(ends.channel, 1);
  box.Add(ends.channel, 3);

  const RowAcknowledgements taken = box.TakeAll();

  EXPECT_TRUE(Includes(taken, ends.channel, 1));
  EXPECT_FALSE(Includes(taken, ends.channel, 2));
  EXPECT_TRUE(Includes(taken, ends.channel, 3));
  EXPECT_TRUE(box.TakeAll().empty());
}

TEST(AcknowledgementQueue, ClosesOnlyChannelsThatAcknowledgeTooMuch) {
  const ProcessAndViewer greedy;
  const ProcessAndViewer modest;
  AcknowledgementQueue box;
  box.Add(modest.channel, 1);

  for (std::uint32_t handle = 0; handle <= AcknowledgementQueue::kMaxOfOneViewer; ++handle) {
    EXPECT_TRUE(greedy.channel->is_open());
    box.Add(greedy.channel, handle);
  }

  EXPECT_FALSE(greedy.channel->is_open());
  EXPECT_TRUE(modest.channel->is_open());
  EXPECT_EQ(box.TakeAll().at(greedy.channel).size(), AcknowledgementQueue::kMaxOfOneViewer);
}

}  // namespace
}  // namespace tendon
