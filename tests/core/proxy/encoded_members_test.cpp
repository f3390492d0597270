#include <gtest/gtest.h>
#include <tendon/interface/connection.h>
#include <tendon/middleware/body.h>
#include <tendon/proxy/event_proxy.h>
#include <tendon/proxy/function_proxy.h>
#include <tendon/proxy/read_offer_proxy.h>

#include <memory>
#include <utility>
#include <vector>

namespace {

/// A payload that counts its copies.
struct Picture {
  Picture() = default;
  Picture(const Picture& other) : pixels(other.pixels) { ++copies; }
  Picture& operator=(const Picture& other) {
    pixels = other.pixels;
    ++copies;
    return *this;
  }
  ~Picture() = default;

  std::vector<double> pixels;
  static inline int copies = 0;
};

}  // namespace

template <>
inline constexpr auto tendon::kPayload<Picture> =
    tendon::Describe("test.Picture", tendon::Field{"pixels", &Picture::pixels});

namespace {

using tendon::Bytes;
using tendon::CommandKind;
using tendon::EncodeBody;
using tendon::Status;

struct Counter {
  void Add(double amount) { sum += amount; }
  void Get(double& value) const { value = sum; }
  double sum = 0;
};

TEST(FunctionProxy, CallsCommandsWithEncodedValues) {
  Counter counter;
  tendon::ProvidedInterface provided("Counter", nullptr);
  provided.AddCommandWrite(&Counter::Add, &counter, "Add");
  provided.AddCommandRead(&Counter::Get, &counter, "Get", tendon::kThreadSafe);
  tendon::RequiredInterface required("Any", nullptr);
  tendon::FunctionProxy add(
      required, tendon::DescribeMember<double, tendon::None>("Add", CommandKind::kWrite));
  tendon::FunctionProxy get(
      required, tendon::DescribeMember<tendon::None, double>("Get", CommandKind::kRead));
  Bytes answer;
  EXPECT_EQ(add(EncodeBody(1.0), answer), Status(Status::kNotConnected));

  const auto connection = tendon::Connection::Make(required, provided, "any", "counter");
  ASSERT_TRUE(connection.ok()) << connection.error().message;

  EXPECT_EQ(add(EncodeBody(2.5), answer), Status(Status::kDone));
  EXPECT_EQ(add(Bytes(3), answer), Status(Status::kInvalid));
  EXPECT_EQ(get(EncodeBody(tendon::None{}), answer), Status(Status::kDone));
  EXPECT_EQ(answer, EncodeBody(2.5));
}

TEST(FunctionProxy, ReplacesAnEarlierAnswer) {
  Counter counter;
  tendon::ProvidedInterface provided("Counter", nullptr);
  provided.AddCommandWrite(&Counter::Add, &counter, "Add");
  tendon::RequiredInterface required("Any", nullptr);
  tendon::FunctionProxy add(
      required, tendon::DescribeMember<double, tendon::None>("Add", CommandKind::kWrite));
  const Bytes before = EncodeBody(std::vector<double>(100, 1.5));

  Bytes answer = before;
  EXPECT_EQ(add(EncodeBody(1.0), answer), Status(Status::kNotConnected));
  EXPECT_EQ(answer, Bytes());

  const auto connection = tendon::Connection::Make(required, provided, "any", "counter");
  ASSERT_TRUE(connection.ok()) << connection.error().message;
  answer = before;
  EXPECT_EQ(add(Bytes(3), answer), Status(Status::kInvalid));
  EXPECT_EQ(answer, Bytes());
  answer = before;
  EXPECT_EQ(add(EncodeBody(2.5), answer), Status(Status::kDone));
  EXPECT_EQ(answer, EncodeBody(tendon::None{}));
}

struct Camera {
  [[nodiscard]] std::shared_ptr<const Picture> newest() const { return newest_picture; }
  std::shared_ptr<const Picture> newest_picture;
};

TEST(SharedRead, IsEncodedInPlaceAndCopiedOnRequest) {
  Camera camera;
  tendon::ProvidedInterface provided("Camera", nullptr);
  provided.AddCommandRead(&Camera::newest, &camera, "Get", tendon::kThreadSafe);
  tendon::RequiredInterface required("Any", nullptr);
  tendon::ReadFunction<Picture> get;
  required.AddFunction(get, "Get");
  tendon::RequiredInterface elsewhere("Elsewhere", nullptr);
  tendon::FunctionProxy encoded(
      elsewhere, tendon::DescribeMember<tendon::None, Picture>("Get", CommandKind::kRead));
  const auto here = tendon::Connection::Make(required, provided, "any", "camera");
  ASSERT_TRUE(here.ok()) << here.error().message;
  const auto there = tendon::Connection::Make(elsewhere, provided, "elsewhere", "camera");
  ASSERT_TRUE(there.ok()) << there.error().message;
  Bytes answer;
  Picture copy;
  EXPECT_EQ(encoded(EncodeBody(tendon::None{}), answer), Status(Status::kNoSample));
  EXPECT_EQ(get(copy), Status(Status::kNoSample));

  auto picture = std::make_shared<Picture>();
  picture->pixels.assign(1000, 0.5);
  camera.newest_picture = std::move(picture);
  Picture::copies = 0;

  EXPECT_EQ(encoded(EncodeBody(tendon::None{}), answer), Status(Status::kDone));
  EXPECT_EQ(answer, EncodeBody(std::vector<double>(1000, 0.5)));
  EXPECT_EQ(Picture::copies, 0);
  EXPECT_EQ(get(copy), Status(Status::kDone));
  EXPECT_EQ(copy.pixels, std::vector<double>(1000, 0.5));
  EXPECT_EQ(Picture::copies, 1);
}

TEST(EventProxy, DeliversEncodedValuesToTypedHandlers) {
  Counter counter;
  tendon::EventProxy event;
  tendon::ProvidedInterface provided("Source", nullptr);
  provided.AddEvent(event,
                    tendon::DescribeMember<double, tendon::None>("Counted", CommandKind::kWrite));
  tendon::RequiredInterface required("Listener", nullptr);
  required.AddEventHandlerWrite(&Counter::Add, &counter, "Counted");
  event.Raise(EncodeBody(1.0));  // no handler is connected
  {
    const auto connection = tendon::Connection::Make(required, provided, "listener", "source");
    ASSERT_TRUE(connection.ok()) << connection.error().message;

    event.Raise(EncodeBody(4.0));
    event.Raise(Bytes(3));
  }
  event.Raise(EncodeBody(8.0));

  EXPECT_EQ(counter.sum, 4.0);
  EXPECT_EQ(event.lost(), 1U);
}

TEST(ReadProxy, AppendsTheStatusToTheAnswer) {
  Bytes answer = EncodeBody(1.0);
  tendon::AppendStatus(Status::kNoSample, answer);

  EXPECT_EQ(tendon::TakeStatus(answer), Status(Status::kNoSample));
  EXPECT_EQ(answer, EncodeBody(1.0));
}

TEST(ReadProxy, AppendingAStatusDoesNotReallocate) {
  Bytes answer(std::size_t{1} << 20U);
  answer.shrink_to_fit();
  tendon::AppendStatus(Status::kDone, answer);

  EXPECT_LE(answer.capacity(), (std::size_t{1} << 20U) + 64);
}

TEST(ReadProxy, RefusesAnInvalidStatus) {
  Bytes nothing;
  Bytes unknown{std::byte{200}};

  EXPECT_EQ(tendon::TakeStatus(nothing), Status(Status::kInvalid));
  EXPECT_EQ(tendon::TakeStatus(unknown), Status(Status::kInvalid));
}

}  // namespace
