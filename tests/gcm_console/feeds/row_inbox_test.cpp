#include <gcm_console/feeds/row_inbox.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace console {
namespace {

using tendon::RowDelivery;

/// An inbox for one column, a number of one byte. The batches have rows with the given ticks.
class RowInboxTest : public testing::Test {
 protected:
  static RowInbox::WantedPath Column() {
    return {
        .path = {.process = "robot", .component = "arm", .interface = "state", .member = "Mode"}};
  }
  static void Begin(RowInbox& printer) {
    printer.OnSubscribed({tendon::Schema(tendon::Schema::Kind::kUint8)});
  }
  static void Hear(RowInbox& printer, const std::vector<std::uint64_t>& ticks,
                   std::uint64_t lost_table, std::uint64_t lost_network) {
    const std::vector<std::int64_t> times(ticks.size());
    const std::byte value{7};
    tendon::RowBatch batch;
    batch.lost.table = lost_table;
    batch.lost.network = lost_network;
    batch.count = ticks.size();
    batch.ticks = ticks;
    batch.times = times;
    batch.cell = [&](std::size_t, std::size_t) { return std::span(&value, 1); };
    printer.OnRows(batch);
  }
};

TEST_F(RowInboxTest, RestCountsWaitingRowsAndAllLosses) {
  RowInbox printer({Column()});
  Begin(printer);
  Hear(printer, {1, 2}, 0, 3);
  ASSERT_EQ(printer.Take().size(), 2U);
  Hear(printer, {7, 8}, 4, 0);
  Hear(printer, {}, 0, 5);

  const tendon::LostRows rest = printer.Rest();

  EXPECT_EQ(rest.table, 4U);
  EXPECT_EQ(rest.network, 5U);
  EXPECT_EQ(rest.viewer, 2U);
  EXPECT_EQ(printer.Rest().all(), 0U) << "said once";
  EXPECT_FALSE(printer.has_more());
}

TEST_F(RowInboxTest, NewestDeliveryCountsNoWaitingRowAsLost) {
  RowInbox printer({Column()}, RowDelivery::kNewest);
  Begin(printer);
  Hear(printer, {1, 2, 3}, 0, 0);

  EXPECT_EQ(printer.Rest().all(), 0U);
}

}  // namespace
}  // namespace console
