#include <gtest/gtest.h>
#include <tendon/process/telemetry/row_batch.h>

#include <random>

namespace {

using tendon::Bytes;
using tendon::RowBatchReader;
using tendon::RowBatchWriter;

Bytes Filled(std::size_t size, int value) { return Bytes(size, static_cast<std::byte>(value)); }
Bytes Copy(std::span<const std::byte> bytes) { return {bytes.begin(), bytes.end()}; }

/// Two rows with a column of 12 bytes, a column of variable size, and a column of 8 bytes.
Bytes SampleBody() {
  RowBatchWriter writer({12, 0, 8});
  writer.BeginRow(5, 500);
  writer.AddCell(Filled(12, 1));
  writer.AddCell(Filled(3, 2));
  writer.AddCell(Filled(8, 3));
  writer.BeginRow(6, 600);
  writer.AddCell(Filled(12, 4));
  writer.AddCell({});
  writer.AddCell(Filled(8, 5));
  return Copy(writer.Finish({.rows_before = 100, .lost_table = 7, .next_tick = 7}));
}

TEST(RowBatch, ReadsBackWhatWasWritten) {
  const Bytes body = SampleBody();

  const auto reader = RowBatchReader::Open(body);

  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->header().rows_before, 100U);
  EXPECT_EQ(reader->header().lost_table, 7U);
  EXPECT_EQ(reader->header().next_tick, 7U);
  EXPECT_EQ(reader->header().rows, 2U);
  EXPECT_EQ(reader->header().columns, 3U);
  EXPECT_EQ(reader->tick(0), 5U);
  EXPECT_EQ(reader->time(1), 600);
  EXPECT_EQ(Copy(reader->cell(0, 0)), Filled(12, 1));
  EXPECT_EQ(Copy(reader->cell(0, 1)), Filled(3, 2));
  EXPECT_EQ(Copy(reader->cell(0, 2)), Filled(8, 3));
  EXPECT_EQ(Copy(reader->cell(1, 0)), Filled(12, 4));
  EXPECT_TRUE(reader->cell(1, 1).empty());
  EXPECT_EQ(Copy(reader->cell(1, 2)), Filled(8, 5));
}

TEST(RowBatch, CanBeReusedAndSentToOtherViewers) {
  RowBatchWriter writer({0});
  for (int round = 0; round < 3; ++round) {
    writer.Clear();
    writer.BeginRow(1, 2);
    writer.AddCell(Filled(5, round));
    for (std::uint64_t viewer = 0; viewer < 2; ++viewer) {
      const Bytes body = Copy(writer.Finish({.rows_before = viewer}));
      const auto reader = RowBatchReader::Open(body);
      ASSERT_TRUE(reader);
      EXPECT_EQ(reader->header().rows_before, viewer);
      EXPECT_EQ(reader->header().rows, 1U);
      EXPECT_EQ(Copy(reader->cell(0, 0)), Filled(5, round));
    }
  }
}

TEST(RowBatch, ReservesRoomForTheFrameHeader) {
  RowBatchWriter writer({12, 0});
  writer.BeginRow(5, 500);
  writer.AddCell(Filled(12, 1));
  writer.AddCell(Filled(3, 2));

  const std::size_t size = writer.size();
  const std::span<std::byte> frame = writer.FinishFrame({.next_tick = 7});

  const auto body = frame.subspan(tendon::FrameHeader::kSize);
  EXPECT_EQ(body.size(), size);
  const auto reader = RowBatchReader::Open(body);
  ASSERT_TRUE(reader);
  EXPECT_EQ(Copy(reader->cell(0, 1)), Filled(3, 2));
  EXPECT_EQ(Copy(writer.Finish({.next_tick = 7})), Copy(body));
}

TEST(RowBatch, MayHaveNoRowsAndNoColumns) {
  RowBatchWriter writer({});
  const Bytes body = Copy(writer.Finish({}));

  const auto reader = RowBatchReader::Open(body);

  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->header().rows, 0U);
}

TEST(RowBatch, RefusesATruncatedBatch) {
  const Bytes body = SampleBody();
  const std::size_t fixed_part = body.size() - 8;  // ends before the only cell of variable size

  for (std::size_t size = 0; size < fixed_part; ++size) {
    EXPECT_FALSE(RowBatchReader::Open(std::span(body).first(size))) << size;
  }
}

TEST(RowBatch, ReadsRandomBytesWithinItsBounds) {
  std::mt19937 random(1);
  for (int round = 0; round < 20'000; ++round) {
    Bytes body = SampleBody();
    for (int change = 0; change < 3; ++change) {
      body[random() % body.size()] = static_cast<std::byte>(random());
    }
    const auto reader = RowBatchReader::Open(body);
    if (!reader) continue;
    for (std::size_t row = 0; row < reader->header().rows; ++row) {
      for (std::size_t column = 0; column < reader->header().columns; ++column) {
        const auto cell = reader->cell(row, column);
        ASSERT_GE(cell.data(), body.data());
        ASSERT_LE(cell.data() + cell.size(), body.data() + body.size());
      }
    }
  }
}

}  // namespace
