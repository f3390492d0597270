#include <gtest/gtest.h>
#include <tendon/recording/recording_format.h>
#include <tendon/recording/row_assembler.h>

#include <optional>

namespace tendon::recording {
namespace {

constexpr RowKey kFirst{.time = 10, .sequence = 1, .run = 0};

mcap::Buffer Body(int value) { return {std::byte(value)}; }

TEST(RowAssemblerTest, MessagesWithTheSameKeyAreOneRow) {
  RowAssembler rows(2);

  EXPECT_TRUE(rows.is_empty());
  rows.Add(1, kFirst, 7, Body(2));
  ASSERT_TRUE(rows.Accepts(0, kFirst));
  rows.Add(0, kFirst, 8, Body(1));
  const AssembledRow row = rows.Take();

  EXPECT_TRUE(rows.is_empty());
  EXPECT_EQ(row.key, kFirst);
  EXPECT_EQ(row.publish_time, 7U) << "of the first message";
  EXPECT_EQ(row.cells[0], Body(1));
  EXPECT_EQ(row.cells[1], Body(2));
}

TEST(RowAssemblerTest, AnotherKeyIsAnotherRow) {
  RowAssembler rows(2);
  rows.Add(0, kFirst, 0, Body(1));

  EXPECT_FALSE(rows.Accepts(1, {.time = 11, .sequence = 1, .run = 0}));
  EXPECT_FALSE(rows.Accepts(1, {.time = 10, .sequence = 2, .run = 0}));
  EXPECT_FALSE(rows.Accepts(1, {.time = 10, .sequence = 1, .run = 1}));
  EXPECT_FALSE(rows.Accepts(0, kFirst)) << "this cell is there already";
}

TEST(RowAssemblerTest, ARowKeepsItsMissingCellsEmpty) {
  RowAssembler rows(2);
  rows.Add(0, kFirst, 0, Body(1));
  (void)rows.Take();
  rows.Add(1, kFirst, 0, Body(2));

  const AssembledRow row = rows.Take();

  EXPECT_FALSE(row.cells[0]) << "nothing is left of the row before";
  EXPECT_TRUE(row.cells[1]);
}

TEST(MissingRowsBetweenTest, CountsTheTicksThatAreSkipped) {
  const std::optional<RowKey> before = kFirst;

  EXPECT_EQ(MissingRowsBetween(before, {.time = 20, .sequence = 2, .run = 0}), 0U);
  EXPECT_EQ(MissingRowsBetween(before, {.time = 20, .sequence = 5, .run = 0}), 3U);
  EXPECT_EQ(MissingRowsBetween(RowKey{.time = 1, .sequence = 0xffff'ffff, .run = 0}, kFirst), 1U)
      << "the low 32 bits of a tick begin again";
}

TEST(MissingRowsBetweenTest, NothingIsMissingAtAStartOrWhenTicksGoBack) {
  EXPECT_EQ(MissingRowsBetween({}, kFirst), 0U);
  EXPECT_EQ(MissingRowsBetween(kFirst, {.time = 20, .sequence = 9, .run = 1}), 0U);
  EXPECT_EQ(MissingRowsBetween(kFirst, {.time = 20, .sequence = 0, .run = 0}), 0U);
  EXPECT_EQ(MissingRowsBetween(kFirst, kFirst), 0U);
}

TEST(RecordingFormatTest, AMessageIsABodyBehindItsEncapsulation) {
  mcap::Buffer data;
  Encapsulate(Body(9), data);

  EXPECT_EQ(data.size(), kEncapsulationSize + 1);
  EXPECT_EQ(BodyOf(data).size(), 1U);
  EXPECT_EQ(BodyOf(data)[0], std::byte{9});
  EXPECT_TRUE(BodyOf(mcap::ByteView(data).first(2)).empty());
}

TEST(RecordingFormatTest, AMessageThatIsNotLittleEndianHasNoBody) {
  mcap::Buffer data;
  Encapsulate(Body(9), data);
  data[1] = std::byte{0};

  EXPECT_TRUE(BodyOf(data).empty());
}

}  // namespace
}  // namespace tendon::recording
