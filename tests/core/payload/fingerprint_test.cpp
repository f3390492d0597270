#include <gtest/gtest.h>
#include <tendon/payload/fingerprint.h>
#include <tests/core/payload/sample_types.h>

#include <set>

namespace tendon {
namespace {

using Kind = Schema::Kind;

Schema Goal(const std::string& name, const std::string& field, const std::string& unit,
            const Schema& type) {
  return Schema::Structure(name, {{field, unit, type}, {"time", "", Schema(Kind::kDuration)}});
}

const Schema kReal(Kind::kFloat64);
const Schema kVector = Schema::Array(kReal, 7);

TEST(Fingerprint, IsThirtyTwoHexadecimalDigits) {
  EXPECT_EQ(ToString(Fingerprint{0x0123456789abcdef, 0xf}), "0123456789abcdef000000000000000f");
}

TEST(Fingerprint, IsXxh3OfTheText) {
  EXPECT_EQ(ToString(FingerprintOf("")), "99aa06d3014798d86001c324468d497f");
}

TEST(Fingerprint, OfATypeEqualsThatOfItsSchema) {
  EXPECT_EQ(FingerprintOf<sample::Dynamic>(), FingerprintOf(SchemaOf<sample::Dynamic>().Text()));
  EXPECT_EQ(FingerprintOf<sample::Dynamic>(), SchemaOf<sample::Dynamic>().fingerprint());
}

TEST(Fingerprint, IdentifiesTheSchema) {
  const auto schema = FindSchema(FingerprintOf<sample::Numbers>());

  ASSERT_TRUE(schema);
  EXPECT_EQ(*schema, SchemaOf<sample::Numbers>());
  EXPECT_FALSE(FindSchema(Fingerprint{1, 2}));
}

/// If this number changes, existing processes and recordings are no longer compatible.
TEST(Fingerprint, NeverChanges) {
  EXPECT_EQ(ToString(FingerprintOf<sample::JointState>()), "13783836e5e54e87009e0ac59d5509af");
  EXPECT_EQ(ToString(FingerprintOf<None>()), "0a54fef99433da665ae59fe784501e58");
}

TEST(Fingerprint, ChangesWithEveryRelevantDifference) {
  const auto mode = [](const std::string& name, std::int32_t value) {
    return Schema::Enum("arm.Mode", {{name, value}});
  };
  const std::vector<Schema> variants{
      Goal("arm.Goal", "position", "rad", kVector),
      Goal("arm.Goal2", "position", "rad", kVector),
      Goal("arm.Goal", "positions", "rad", kVector),
      Goal("arm.Goal", "position", "deg", kVector),
      Goal("arm.Goal", "position", "", kVector),
      Goal("arm.Goal", "position", "rad", Schema::Array(kReal, 6)),
      Goal("arm.Goal", "position", "rad", Schema::Array(Schema(Kind::kFloat32), 7)),
      Goal("arm.Goal", "position", "rad", Schema::Sequence(kReal)),
      Goal("arm.Goal", "position", "rad", Schema::Array(Schema::Array(kReal, 7), 1)),
      Goal("arm.Goal", "position", "rad", kReal),
      Goal("arm.Goal", "position", "rad", Goal("arm.Inner", "position", "", kVector)),
      Goal("arm.Goal", "position", "rad", Goal("arm.Inner", "position", "rad", kVector)),
      Goal("arm.Goal", "position", "rad", mode("off", 0)),
      Goal("arm.Goal", "position", "rad", mode("on", 0)),
      Goal("arm.Goal", "position", "rad", mode("off", 1)),
      Goal("arm.Goal", "position", "rad", Schema(Kind::kInt32)),
      Schema::Structure("arm.Goal", {{"position", "rad", kVector}}),
  };
  std::set<Fingerprint> fingerprints;

  for (const Schema& schema : variants) fingerprints.insert(schema.fingerprint());

  EXPECT_EQ(fingerprints.size(), variants.size());
}

struct PointOfAnotherLibrary {
  float unused = 0;
  double a = 0;
  double b = 0;
  double c = 0;
};

TEST(Fingerprint, DoesNotChangeWithTheCppType) {
  EXPECT_EQ(FingerprintOf<std::chrono::hours>(), FingerprintOf<std::chrono::duration<float>>());
  EXPECT_EQ(FingerprintOf<std::byte>(), FingerprintOf<std::uint8_t>());
  EXPECT_EQ(FingerprintOf<sample::Plain>(), FingerprintOf<std::int32_t>());
  EXPECT_EQ(FingerprintOf<long>(), FingerprintOf<long long>());
}

}  // namespace
}  // namespace tendon

template <>
inline constexpr auto tendon::kPayload<tendon::PointOfAnotherLibrary> =
    tendon::Describe("sample.Point", tendon::Field{"x", &tendon::PointOfAnotherLibrary::b},
                     tendon::Field{"y", &tendon::PointOfAnotherLibrary::a},
                     tendon::Field{"z", &tendon::PointOfAnotherLibrary::c});

namespace tendon {
namespace {

TEST(Fingerprint, DoesNotChangeWithMemberNamesOrLayout) {
  EXPECT_EQ(FingerprintOf<PointOfAnotherLibrary>(), FingerprintOf<sample::Point>());
}

}  // namespace
}  // namespace tendon
