#include <gcm_gui/views/raw_image.h>
#include <gtest/gtest.h>
#include <tendon/payload/codec.h>
#include <tendon/payload/json.h>
#include <tendon/payload/robot/image.h>

#include <cstdint>
#include <string>
#include <vector>

namespace tendon::gui {
namespace {

/// Two rows with a red and a green pixel each; a padding byte ends each row.
robot::Image SmallImage() {
  robot::Image image;
  image.header.frame_id = "camera";
  image.height = 2;
  image.width = 2;
  image.encoding = "rgb8";
  image.step = 7;
  image.data = {255, 0, 0, 0, 255, 0, 9, 255, 0, 0, 0, 255, 0, 9};
  return image;
}

std::vector<std::byte> BodyOf(const robot::Image& image) {
  std::vector<std::byte> body;
  Encode(image, body);
  return body;
}

RawImage Grey(std::uint64_t width, std::uint64_t height, qsizetype bytes) {
  return {.width = width, .height = height, .encoding = "mono8", .data = QByteArray(bytes, '\x40')};
}

void ExpectSmall(const std::optional<RawImage>& picture) {
  ASSERT_TRUE(picture.has_value());
  const auto drawn = Draw(*picture);
  ASSERT_TRUE(drawn.ok()) << drawn.error().message;
  EXPECT_EQ(drawn->size(), QSize(2, 2));
  EXPECT_EQ(drawn->pixelColor(0, 1), QColor(255, 0, 0));
  EXPECT_EQ(drawn->pixelColor(1, 0), QColor(0, 255, 0));
}

TEST(RawImage, DecodesABodyByItsSchema) {
  const Schema schema = SchemaOf<robot::Image>();
  ASSERT_TRUE(DescribesImage(schema));

  const auto body = BodyOf(SmallImage());
  ExpectSmall(RawImageOf(schema, body));

  for (std::size_t size = 0; size + 16 < body.size(); ++size) {
    EXPECT_FALSE(RawImageOf(schema, std::span(body).first(size)).has_value()) << size;
  }
}

TEST(RawImage, ParsesAJsonReply) {
  const auto json = ToJson(SchemaOf<robot::Image>(), BodyOf(SmallImage()));
  ASSERT_TRUE(json.ok());

  ASSERT_TRUE(LooksLikeImage(*json));
  ExpectSmall(RawImageOf(*json));
}

TEST(RawImage, AcceptsAChannelCountInsteadOfAnEncoding) {
  const std::string json =
      R"({"width":2,"height":2,"channels":3,"data":[255,0,0,0,255,0,255,0,0,0,255,0]})";

  ASSERT_TRUE(LooksLikeImage(json));
  ExpectSmall(RawImageOf(json));
}

TEST(RawImage, RejectsOtherValues) {
  EXPECT_FALSE(DescribesImage(Schema(Schema::Kind::kFloat64)));
  EXPECT_FALSE(DescribesImage(SchemaOf<robot::Header>()));
  EXPECT_FALSE(LooksLikeImage(R"({"width":2,"height":2})"));
  EXPECT_FALSE(RawImageOf(std::string(R"({"width":2,"height":2,"encoding":"mono8","data":"x"})")));
  EXPECT_FALSE(
      RawImageOf(std::string(R"({"width":1,"height":1,"encoding":"mono8","data":[256]})")));
}

TEST(RawImage, ReadsSixteenBitPixelsInTheGivenByteOrder) {
  RawImage picture{.width = 2, .height = 1, .encoding = "mono16", .data = {}};
  picture.data = QByteArray("\x00\xff\xff\x00", 4);
  const auto little = Draw(picture);
  picture.is_bigendian = true;
  const auto big = Draw(picture);

  ASSERT_TRUE(little.ok() && big.ok());
  EXPECT_GT(little->pixelColor(0, 0).value(), little->pixelColor(1, 0).value());
  EXPECT_LT(big->pixelColor(0, 0).value(), big->pixelColor(1, 0).value());
}

TEST(RawImage, ReportsInconsistentPictures) {
  RawImage short_rows = Grey(4, 2, 8);
  short_rows.step = 3;
  RawImage unknown = Grey(2, 2, 16);
  unknown.encoding = "32FC1";
  const std::vector<std::pair<RawImage, std::string>> wrong = {
      {Grey(4, 2, 7), "2 rows of 4 bytes do not match the 7 bytes of data"},
      {Grey(4, 2, 9), "2 rows of 4 bytes do not match the 9 bytes of data"},
      {short_rows, "a row of 4 pixels in mono8 needs 4 bytes, but the field step is 3"},
      {unknown, "a picture with encoding '32FC1' cannot be drawn"},
      {Grey(0, 2, 0), "a picture of 0 × 2 pixels is empty: width and height must be above 0"},
      {Grey(std::uint64_t{1} << 40U, 2, 4), "too large to be drawn"},
      {Grey(2, ~std::uint64_t{0}, 4), "too large to be drawn"}};
  for (const auto& [picture, words] : wrong) {
    const auto drawn = Draw(picture);
    ASSERT_FALSE(drawn.ok()) << words;
    EXPECT_NE(drawn.error().message.find(words), std::string::npos) << drawn.error().message;
  }
}

}  // namespace
}  // namespace tendon::gui
