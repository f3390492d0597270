#include <tendon/process/telemetry/receipts/row_receipts.h>

#include "core/process/telemetry/listening.h"
#include "support/wait.h"

namespace tendon {
namespace {

TEST(ReceiptBox, GivesEachOnceToWhoTakesThem) {
  const ProcessAndViewer ends;
  ReceiptBox box;
  box.Add(ends.channel, 1);
  box.Add(ends.channel, 1);
  box.Add(ends.channel, 3);

  const RowReceipts taken = box.TakeAll();

  EXPECT_TRUE(Includes(taken, ends.channel, 1));
  EXPECT_FALSE(Includes(taken, ends.channel, 2));
  EXPECT_TRUE(Includes(taken, ends.channel, 3));
  EXPECT_TRUE(box.TakeAll().empty());
}

TEST(ReceiptBox, CutsOffWhoHasTakenMoreThanItCanHaveAndNobodyElse) {
  const ProcessAndViewer greedy;
  const ProcessAndViewer modest;
  ReceiptBox box;
  box.Add(modest.channel, 1);

  for (std::uint32_t handle = 0; handle <= ReceiptBox::kMostOfOneViewer; ++handle) {
    EXPECT_TRUE(greedy.channel->is_open());
    box.Add(greedy.channel, handle);
  }

  EXPECT_FALSE(greedy.channel->is_open());
  EXPECT_TRUE(modest.channel->is_open());
  EXPECT_EQ(box.TakeAll().at(greedy.channel).size(), ReceiptBox::kMostOfOneViewer);
}

}  // namespace
}  // namespace tendon
