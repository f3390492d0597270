#include <gtest/gtest.h>
#include <tendon/payload/codec.h>
#include <tendon/payload/payload.h>
#include <tests/core/payload/sample_types.h>

#include <map>
#include <memory>
#include <vector>

namespace {

struct Stamped : sample::Point {
  std::int64_t time = 0;
};

/// Looks like a view, but has a description.
struct Window {
  int first = 0;
  [[nodiscard]] const int* data() const { return &first; }
  [[nodiscard]] static std::size_t size() { return 1; }
};
struct Framed {
  Window window;
  std::vector<std::byte> bytes;
};

struct NotDescribedAtAll {
  int number = 0;
};

enum class Huge : std::uint64_t {};

}  // namespace

template <>
inline constexpr auto tendon::kPayload<Stamped> =
    tendon::Describe("sample.Stamped", tendon::Field{"time", &Stamped::time, "ns"},
                     tendon::Field{"x", &Stamped::x, "m"});

template <>
inline constexpr auto tendon::kPayload<Window> =
    tendon::Describe("sample.Window", tendon::Field{"first", &Window::first});
template <>
inline constexpr auto tendon::kPayload<Framed> =
    tendon::Describe("sample.Framed", tendon::Field{"window", &Framed::window},
                     tendon::Field{"bytes", &Framed::bytes});

namespace tendon {
namespace {

TEST(Description, DefinesWhichTypesArePayloads) {
  static_assert(Payload<bool> && Payload<std::byte> && Payload<long> && Payload<long long>);
  static_assert(Payload<std::string> && Payload<std::vector<std::array<std::string, 2>>>);
  static_assert(Payload<std::chrono::hours> && Payload<std::chrono::duration<float>>);
  static_assert(Payload<None> && Payload<sample::Mode> && Payload<sample::Dynamic>);

  static_assert(!Payload<NotDescribedAtAll> && !Payload<std::vector<NotDescribedAtAll>>);
  static_assert(!Payload<char> && !Payload<wchar_t> && !Payload<long double> && !Payload<Huge>);
  static_assert(!Payload<int*> && !Payload<const char*> && !Payload<std::unique_ptr<int>>);
  static_assert(!Payload<const int> && !Payload<int&> && !Payload<std::array<int, 0>>);
  static_assert(!Payload<std::chrono::duration<int, std::pico>>);
  static_assert(!Payload<std::map<int, int>> && !Payload<std::string_view>);
}

TEST(Description, AFieldThatLooksLikeAViewIsAPayloadIfItIsDescribed) {
  static_assert(Payload<Window> && Payload<std::vector<Window>> && Payload<Framed>);
}

TEST(Description, DefinesWhichPayloadsHaveAFixedSize) {
  static_assert(FixedPayload<double> && FixedPayload<sample::Fixed> && FixedPayload<None>);
  static_assert(!FixedPayload<std::string> && !FixedPayload<std::vector<int>>);
  static_assert(!FixedPayload<std::array<std::string, 2>> && !FixedPayload<sample::Dynamic>);
}

TEST(Description, DistinguishesDescribedFromBuiltInTypes) {
  static_assert(Described<sample::Point> && Described<sample::Mode> && Described<None>);
  static_assert(!Described<int> && !Described<sample::Plain> && !Described<NotDescribedAtAll>);
}

TEST(Description, AMemberOfABaseClassIsAField) {
  Stamped value;
  value.x = 2.5;
  value.time = 7;
  std::vector<std::byte> body;
  Encode(value, body);
  Stamped decoded;

  ASSERT_TRUE(Decode(body, decoded));

  EXPECT_EQ(decoded.x, 2.5);
  EXPECT_EQ(decoded.time, 7);
}

TEST(Description, NamesAnEnumsValue) {
  EXPECT_EQ(NameOf(sample::Mode::kTracking), "tracking");
  EXPECT_EQ(NameOf(static_cast<sample::Mode>(99)), "?");
}

TEST(Description, ATypeIsNamedByIdentifiersAndDots) {
  for (const char* good : {"Point", "arm.JointState", "a.b_c.D9"}) {
    EXPECT_TRUE(payload::IsTypeName(good)) << good;
  }
  for (const char* bad : {"", ".", "arm.", ".Arm", "arm..Arm", "arm::Arm", "9arm.A", "arm.A b"}) {
    EXPECT_FALSE(payload::IsTypeName(bad)) << bad;
  }
  EXPECT_FALSE(payload::IsTypeName(std::string(65, 'a')));
}

TEST(Description, AUnitIsShortAndPrintable) {
  for (const char* good : {"", "rad/s", "°C", "N m", "%"}) {
    EXPECT_TRUE(payload::IsUnit(good)) << good;
  }
  for (const char* bad : {" m", "m ", "m\n", "\t", "\x7f"}) {
    EXPECT_FALSE(payload::IsUnit(bad)) << bad;
  }
  EXPECT_FALSE(payload::IsUnit(std::string(33, 'm')));
}

}  // namespace
}  // namespace tendon
