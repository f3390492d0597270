#include <gtest/gtest.h>
#include <tendon/middleware/requests/reply_batch.h>

#include <limits>
#include <utility>
#include <vector>

namespace tendon {
namespace {

using Reply = std::pair<std::uint64_t, Bytes>;

std::vector<Reply> RepliesIn(std::span<const std::byte> body) {
  std::vector<Reply> all;
  while (const auto one = TakeReply(body)) {
    all.emplace_back(one->request, Bytes(one->answer.begin(), one->answer.end()));
  }
  return all;
}

/// Two answers, of two bytes and of none.
Bytes TwoReplies() {
  ReplyBatch batch;
  EXPECT_TRUE(batch.Add(7, Bytes(2, std::byte{5})));
  EXPECT_TRUE(batch.Add(std::numeric_limits<std::uint64_t>::max(), {}));
  return batch.body();
}

TEST(ReplyBatch, KeepsTheOrder) {
  const std::vector<Reply> expected{{7, Bytes(2, std::byte{5})},
                                    {std::numeric_limits<std::uint64_t>::max(), {}}};

  EXPECT_EQ(RepliesIn(TwoReplies()), expected);
  EXPECT_TRUE(IsReplyBatch(TwoReplies()));
}

TEST(ReplyBatch, HasTheBytesOfTheProtocol) {
  const auto bytes = [](std::initializer_list<unsigned char> all) {
    Bytes result;
    for (const unsigned char one : all) result.push_back(std::byte{one});
    return result;
  };
  EXPECT_EQ(TwoReplies(), bytes({7,   0,   0,   0,   0,   0,   0,   0,  // request
                                 2,   0,   0,   0,   5,   5,            // answer
                                 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0}));
}

TEST(ReplyBatch, TakesSoManyAndNoMore) {
  ReplyBatch batch;
  for (std::uint64_t i = 1; i <= ReplyBatch::kMostReplies; ++i) EXPECT_TRUE(batch.Add(i, {}));

  EXPECT_FALSE(batch.Add(1000, {}));
  EXPECT_EQ(batch.replies(), ReplyBatch::kMostReplies);
  EXPECT_TRUE(IsReplyBatch(batch.body()));
  batch.Clear();
  EXPECT_TRUE(batch.Add(1000, {}));
}

TEST(ReplyBatch, TakesSoManyBytesAndNoMore) {
  constexpr std::size_t kLargest = ReplyBatch::kMostBytes - ReplyBatch::kOverhead;
  ReplyBatch batch;

  EXPECT_FALSE(batch.Add(1, Bytes(kLargest + 1)));
  EXPECT_FALSE(batch.Add(1, Bytes(2 * kLargest)));
  EXPECT_EQ(batch.replies(), 0U);
  EXPECT_TRUE(batch.Add(1, Bytes(kLargest)));
  EXPECT_FALSE(batch.Add(2, {}));
  EXPECT_TRUE(IsReplyBatch(batch.body()));
}

TEST(ReplyBatch, OfALiarIsNone) {
  const Bytes whole = TwoReplies();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const bool ends_with_a_reply = size == ReplyBatch::kOverhead + 2;
    EXPECT_EQ(IsReplyBatch(std::span(whole).first(size)), ends_with_a_reply) << size << " bytes";
  }
  Bytes longer = whole;
  longer.push_back(std::byte{0});
  EXPECT_FALSE(IsReplyBatch(longer));
  for (std::size_t i = 8; i < 12; ++i) {  // of the first one's size
    Bytes claims_more = whole;
    claims_more[i] = std::byte{255};
    EXPECT_FALSE(IsReplyBatch(claims_more)) << "byte " << i;
  }
}

TEST(ReplyBatch, OfTooManyOrTooLargeIsNone) {
  EXPECT_FALSE(IsReplyBatch(Bytes((ReplyBatch::kMostReplies + 1) * ReplyBatch::kOverhead)));
  Bytes large(ReplyBatch::kMostBytes + 1);
  const auto size = static_cast<std::uint32_t>(large.size() - ReplyBatch::kOverhead);
  for (std::size_t i = 0; i < 4; ++i) large[8 + i] = static_cast<std::byte>(size >> (8 * i));

  EXPECT_EQ(RepliesIn(large).size(), 1U);
  EXPECT_FALSE(IsReplyBatch(large));
}

}  // namespace
}  // namespace tendon
