#include <gtest/gtest.h>
#include <tendon/payload/codec.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/payload/shared_list.h>

#include <string>
#include <utility>

namespace tendon {
namespace {

using Words = SharedList<std::string>;

TEST(SharedList, IsAVectorUntilItIsShared) {
  const Words words = {"one", "two"};
  const Words copy = words;

  EXPECT_EQ(words.size(), 2U);
  EXPECT_EQ(words[1], "two");
  EXPECT_EQ(copy, words);
  EXPECT_NE(copy.data(), words.data());
  EXPECT_EQ(words.holders(), 1);
}

TEST(SharedList, CopiesOfASharedListShareTheirItems) {
  Words words = {"one", "two"};
  words.Share();
  words.Share();

  const Words copy = words;

  EXPECT_EQ(copy.items(), (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(copy.data(), std::as_const(words).data());
  EXPECT_EQ(words.holders(), 2);
}

TEST(SharedList, ChangingACopyKeepsTheOthers) {
  Words words = {"one"};
  words.Share();
  Words copy = words;

  copy.push_back("two");
  copy[0] = "zero";

  EXPECT_EQ(words, Words({"one"}));
  EXPECT_EQ(copy, Words({"zero", "two"}));
  EXPECT_EQ(words.holders(), 1);
}

TEST(SharedList, IsComparedByContent) {
  Words shared = {"one"};
  shared.Share();
  Words other = {"one"};
  EXPECT_EQ(shared, other);
  other.Share();
  EXPECT_EQ(shared, other);
  EXPECT_NE(shared, Words({"two"}));
  other.clear();
  EXPECT_EQ(other, Words());
}

TEST(SharedList, IsEncodedAsAVector) {
  EXPECT_EQ(FingerprintOf<Words>(), FingerprintOf<std::vector<std::string>>());
  Words words = {"one", "two"};
  words.Share();
  std::vector<std::byte> body;
  Encode(words, body);

  std::vector<std::string> read;
  EXPECT_TRUE(Decode(body, read));
  EXPECT_EQ(read, words.items());
  Words again = words;
  EXPECT_TRUE(Decode(body, again));
  EXPECT_EQ(again, words);
  EXPECT_NE(std::as_const(again).data(), std::as_const(words).data());
}

}  // namespace
}  // namespace tendon
