#include <gtest/gtest.h>
#include <support/peers/traced_channel.h>
#include <tendon/process/telemetry/row_stream.h>

#include "support/wait.h"

namespace tendon {
namespace {

/// Two streams of the same table, without columns, in one thread.
class RowStreams : public testing::TestWithParam<RowDelivery> {
 protected:
  static void Send(RowStream& stream, std::uint64_t tick) {
    stream.Take(tick, 0, {});
    stream.Send(0, tick + 1);
  }

  const test::TracedChannel channel_;
  const StateTable table_;
  RowStream first_{table_, {}, {.delivery = GetParam()}};
  RowStream second_{table_, {}, {.delivery = GetParam()}};
};

TEST_P(RowStreams, SendTheirRowsWithoutACopy) {
  first_.Add(channel_.get(), 1, channel_->NewLane());
  second_.Add(channel_.get(), 2, channel_->NewLane());

  Send(first_, 5);
  Send(second_, 5);

  const auto places = channel_.PlacesOf(message::kRows);
  ASSERT_EQ(places.size(), 2U);
  EXPECT_NE(places[0], places[1]);
}

TEST_P(RowStreams, SendEachViewerItsOwnHeader) {
  first_.Add(channel_.get(), 1, channel_->NewLane());
  Send(first_, 5);
  first_.Add(channel_.get(), 2, channel_->NewLane());
  first_.OnRowsTaken({{channel_.get(), {1}}});
  Send(first_, 6);

  ASSERT_TRUE(EventuallyTrue([&] { return channel_.notices().size() == 3; }));
  const auto rows_before = [&](std::size_t notice) {
    const auto reader = RowBatchReader::Open(channel_.notices()[notice].body);
    return reader ? reader->header().rows_before : 99;
  };
  EXPECT_EQ(channel_.notices()[1].handle, 1U);
  EXPECT_EQ(rows_before(1), 1U);
  EXPECT_EQ(channel_.notices()[2].handle, 2U);
  EXPECT_EQ(rows_before(2), 0U);
}

INSTANTIATE_TEST_SUITE_P(, RowStreams, testing::Values(RowDelivery::kAll, RowDelivery::kNewest),
                         [](const auto& delivery) {
                           return delivery.param == RowDelivery::kAll ? "All" : "Newest";
                         });

}  // namespace
}  // namespace tendon
