#include <gtest/gtest.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/client/log_feed.h>
#include <tendon/middleware/loopback.h>
#include <tendon/middleware/part_sender.h>
#include <tendon/middleware/pending_requests.h>
#include <tendon/process/telemetry/row_batch.h>
#include <tendon/process/telemetry/row_subscription.h>
#include <tests/core/gcm/samples.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace tendon {
namespace {

constexpr std::uint64_t kMax = std::numeric_limits<std::uint64_t>::max();

/// Records the ticks of its rows, and the number of lost rows.
class TickRecord final : public RowSink {
 public:
  void OnSubscribed(const std::vector<Schema>& /*columns*/) override {}
  void OnRows(const RowBatch& batch) override {
    ticks.insert(ticks.end(), batch.ticks.begin(), batch.ticks.end());
    lost += batch.lost;
  }
  void OnStale(const Error& /*reason*/) override {}

  std::vector<std::uint64_t> ticks;
  LostRows lost;
};

/// A viewer of a table, and a process that can send any numbers.
class RowNumbers : public testing::Test {
 protected:
  /// Sends rows with these ticks. `before` is the number of rows that were sent earlier.
  void Send(std::uint64_t before, const std::vector<std::uint64_t>& ticks,
            std::uint64_t next_tick) {
    RowBatchWriter writer({});
    for (const std::uint64_t tick : ticks) writer.BeginRow(tick, 0);
    subscription_.Deliver(beginning_,
                          writer.Finish({.rows_before = before, .next_tick = next_tick}), {});
  }

  std::shared_ptr<TickRecord> record_ = std::make_shared<TickRecord>();
  RowSubscription subscription_{
      {.process = "robot", .component = "arm", .table = "state", .columns = {}, .rows = {}},
      record_};
  const std::uint64_t beginning_ =
      *subscription_.Begin({.handle = 1, .epoch = 1, .first_tick = 100});
};

TEST_F(RowNumbers, DeliversNoRowTwice) {
  Send(0, {100, 101, 102}, 103);

  Send(0, {100, 101, 102}, 103);  // all rows again
  Send(3, {102, 103}, 104);       // one row again
  Send(3, {103, 103}, 104);       // the same row twice in one batch
  Send(3, {104, 103}, 105);
  Send(3, {103}, 103);  // the next tick is not above the last row
  Send(2, {103}, 104);  // fewer earlier rows than before

  EXPECT_EQ(record_->ticks, (std::vector<std::uint64_t>{100, 101, 102}));
  Send(3, {103}, 104);
  EXPECT_EQ(record_->ticks, (std::vector<std::uint64_t>{100, 101, 102, 103}));
  EXPECT_EQ(record_->lost, LostRows());
}

TEST_F(RowNumbers, CountsSkippedRowsAsLost) {
  Send(0, {100}, 101);

  Send(11, {111}, 112);

  EXPECT_EQ(record_->ticks, (std::vector<std::uint64_t>{100, 111}));
  EXPECT_EQ(record_->lost, (LostRows{.network = 10}));
}

TEST_F(RowNumbers, IgnoresRowNumbersThatOverflow) {
  Send(kMax, {kMax - 1}, kMax);

  Send(0, {100}, 101);
  EXPECT_EQ(record_->ticks.size(), 1U);
  EXPECT_EQ(record_->lost, LostRows());
}

message::LogRecords Records(std::uint64_t before, const std::vector<std::string>& texts) {
  message::LogRecords batch{before, {}};
  for (const std::string& text : texts) batch.records.push_back({.text = text});
  return batch;
}

std::vector<std::string> TextsOf(const LogBatch& batch) {
  std::vector<std::string> texts;
  for (const auto& record : batch.records) texts.push_back(record.text);
  return texts;
}

TEST(JumpingNumbers, DeliversNoRecordTwiceAndCountsSkippedOnes) {
  using Texts = std::vector<std::string>;
  client::LogFeed feed;
  feed.Begin({1, 100, 100});
  EXPECT_EQ(TextsOf(feed.Take(Records(100, {"a", "b"}))), (Texts{"a", "b"}));

  EXPECT_EQ(TextsOf(feed.Take(Records(100, {"a", "b"}))), Texts{});
  EXPECT_EQ(TextsOf(feed.Take(Records(101, {"b", "c"}))), Texts{"c"});
  EXPECT_EQ(TextsOf(feed.Take(Records(0, {"z"}))), Texts{});
  EXPECT_EQ(TextsOf(feed.Take(Records(kMax, {"x", "y"}))), Texts{});

  const LogBatch next = feed.Take(Records(105, {"d"}));
  EXPECT_EQ(TextsOf(next), Texts{"d"});
  EXPECT_EQ(next.lost, 2U);
  EXPECT_EQ(feed.Wanted().after, 106U);
}

TEST(JumpingNumbers, RefusesCatalogueChangesOutOfSequence) {
  Catalogue catalogue;
  const auto change = [](std::uint64_t revision) {
    return CatalogueChange{.revision = revision,
                           .kind = CatalogueChange::Kind::kProcess,
                           .process = "robot",
                           .processes = {test::ProcessNamed("robot", revision)}};
  };
  ASSERT_TRUE(catalogue.Apply(change(1)));
  ASSERT_TRUE(catalogue.Apply(change(2)));
  const Catalogue before = catalogue;

  for (const std::uint64_t revision :
       {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{2}, std::uint64_t{4}, kMax}) {
    EXPECT_FALSE(catalogue.Apply(change(revision))) << revision;
    EXPECT_EQ(catalogue, before) << revision;
  }

  EXPECT_TRUE(catalogue.Apply(change(3)));
}

TEST(JumpingNumbers, IgnoresRepliesWithAnUnexpectedNumber) {
  PendingRequests requests;
  std::uint64_t before = 0;
  {
    const BlockingRequest answered(requests);
    before = answered.number();
  }
  BlockingRequest answer(requests);

  for (const std::uint64_t number : {std::uint64_t{0}, before, answer.number() + 1, kMax}) {
    EXPECT_FALSE(requests.Finish(number, Error{ErrorCode::kFailed, "a lie"})) << number;
  }

  EXPECT_FALSE(answer.WaitUntil(SteadyClock().Now()).has_value());
}

/// A link that discards everything that is sent.
class Hole final : public Link {
 public:
  Status Send(std::span<const std::byte> /*frame*/, Delivery /*delivery*/) override {
    return Status::kQueued;
  }
  void Admit() override {}
  void Close() override {}
  [[nodiscard]] std::string peer() const override { return "peer"; }
  [[nodiscard]] std::string local() const override { return "here"; }
};

TEST(JumpingNumbers, RefusesAnImplausibleCountOfPartsTaken) {
  Hole link;
  PartSender sender;
  const Bytes body(2 * kMinPartSize);
  ASSERT_TRUE(
      sender.Add(link, kCommonLane, {.size = static_cast<std::uint32_t>(body.size())}, body));
  ASSERT_TRUE(sender.OnTaken(link, kMinPartSize));

  EXPECT_FALSE(sender.OnTaken(link, kMinPartSize - 1));
  EXPECT_FALSE(sender.OnTaken(link, kMax));

  EXPECT_TRUE(sender.OnTaken(link, FrameHeader::kSize + body.size()));
  EXPECT_EQ(sender.waiting(), 0U);
}

}  // namespace
}  // namespace tendon
