#include <gtest/gtest.h>
#include <tendon/ice/bounded_reader.h>

#include <initializer_list>
#include <random>

namespace tendon::ice {
namespace {

Bytes BytesOf(std::initializer_list<int> values) {
  Bytes bytes;
  for (const int value : values) bytes.push_back(static_cast<std::byte>(value));
  return bytes;
}

Bytes Written(std::size_t size) {
  Bytes encapsulation;
  WriteOnlyParameter(Bytes(size, std::byte{42}), encapsulation);
  return encapsulation;
}

TEST(BoundedReader, ReadsPresentValues) {
  const Bytes bytes = BytesOf({7, 1, 0, 0, 0x80, 2, 8, 9});
  BoundedReader reader(bytes);

  EXPECT_EQ(reader.ReadByte(), 7);
  EXPECT_EQ(reader.ReadInt(), static_cast<std::int32_t>(0x80000001U));
  EXPECT_EQ(reader.ReadSize(), 2U);
  EXPECT_EQ(reader.ReadBytes(2)->size(), 2U);
  EXPECT_TRUE(reader.AtEnd());
}

TEST(BoundedReader, ReadsNothingBeyondTheEnd) {
  const Bytes bytes = BytesOf({1, 2, 3});

  EXPECT_FALSE(BoundedReader(bytes).ReadInt());
  EXPECT_FALSE(BoundedReader(bytes).ReadBytes(4));
  EXPECT_FALSE(BoundedReader({}).ReadByte());
  EXPECT_FALSE(BoundedReader({}).ReadSize());
}

TEST(BoundedReader, RefusesASizeBeyondTheEnd) {
  const auto size_of = [](std::initializer_list<int> values) {
    const Bytes bytes = BytesOf(values);
    return BoundedReader(bytes).ReadSize();
  };

  EXPECT_EQ(size_of({2, 0, 0}), 2U);
  EXPECT_FALSE(size_of({3, 0, 0}));
  EXPECT_FALSE(size_of({255, 0, 0}));
  EXPECT_EQ(size_of({255, 1, 0, 0, 0, 9}), 1U);
  EXPECT_FALSE(size_of({255, 2, 0, 0, 0, 9}));
  EXPECT_FALSE(size_of({255, 255, 255, 255, 255, 9})) << "-1";
  EXPECT_FALSE(size_of({255, 255, 255, 255, 127, 9})) << "2^31 - 1";
  EXPECT_FALSE(size_of({255, 0, 0, 0, 32, 9})) << "2^29";
}

TEST(OnlyParameter, ReadsBackWhatWasWritten) {
  for (const std::size_t size : {0U, 1U, 254U, 255U, 256U, 100000U}) {
    const Bytes encapsulation = Written(size);
    const auto parameter = ReadOnlyParameter(encapsulation);

    ASSERT_TRUE(parameter) << size;
    EXPECT_EQ(Bytes(parameter->begin(), parameter->end()), Bytes(size, std::byte{42}));
  }
}

TEST(OnlyParameter, RefusesTrailingBytes) {
  Bytes encapsulation = BytesOf({9, 0, 0, 0, 1, 1, 1, 5, 6});

  EXPECT_FALSE(ReadOnlyParameter(encapsulation));
}

TEST(OnlyParameter, RefusesAWrongEncapsulationSize) {
  for (const int size : {0, 5, 7, 9, 255}) {
    EXPECT_FALSE(ReadOnlyParameter(BytesOf({size, 0, 0, 0, 1, 1, 1, 5}))) << size;
  }
  EXPECT_FALSE(ReadOnlyParameter(BytesOf({251, 255, 255, 255, 1, 1, 1, 5}))) << "-5";
  EXPECT_TRUE(ReadOnlyParameter(BytesOf({8, 0, 0, 0, 1, 1, 1, 5})));
}

TEST(OnlyParameter, AcceptsOnlyKnownEncodings) {
  EXPECT_TRUE(ReadOnlyParameter(BytesOf({8, 0, 0, 0, 1, 0, 1, 5})));
  EXPECT_FALSE(ReadOnlyParameter(BytesOf({8, 0, 0, 0, 1, 2, 1, 5})));
  EXPECT_FALSE(ReadOnlyParameter(BytesOf({8, 0, 0, 0, 2, 0, 1, 5})));
}

TEST(OnlyParameter, ReadsRandomBytesWithinTheirBounds) {
  std::mt19937 random(1);
  const Bytes good = Written(300);
  for (int i = 0; i < 100000; ++i) {
    Bytes bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(random() % good.size()));
    for (int change = 0; change < 3 && !bytes.empty(); ++change) {
      bytes[random() % std::min<std::size_t>(bytes.size(), 12)] = static_cast<std::byte>(random());
    }
    const auto parameter = ReadOnlyParameter(bytes);
    if (!parameter) continue;
    ASSERT_GE(parameter->data(), bytes.data());
    ASSERT_LE(parameter->data() + parameter->size(), bytes.data() + bytes.size());
  }
}

}  // namespace
}  // namespace tendon::ice
