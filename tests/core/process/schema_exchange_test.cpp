#include <gmock/gmock.h>
#include <tendon/base/log.h>
#include <tendon/process/schema_exchange.h>

#include <string>

#include "support/record.h"

namespace {

using tendon::FindSchema;
using tendon::LogLevel;
using tendon::Schema;
using tendon::SchemaCache;

/// Returns a type that no other test uses.
Schema Type(const std::string& name) {
  const auto parsed = Schema::Parse("struct " + name + " {\n  value: float64\n}\n");
  EXPECT_TRUE(parsed.ok()) << parsed.error().message;
  return parsed ? *parsed : Schema();
}

/// Records the warnings about types from now on.
tendon::test::Record<std::string>& Listen() {
  static tendon::test::Record<std::string> warnings;
  static const bool is_added = [] {
    tendon::AddLogSink([](LogLevel level, std::string_view source, std::string_view text) {
      if (level != LogLevel::kWarning || source != "types") return;
      warnings.Add(std::string(text));
    });
    return true;
  }();
  EXPECT_TRUE(is_added);
  (void)warnings.Take();
  return warnings;
}

TEST(SchemaCache, LimitsItsTypesAndWarnsOnce) {
  const auto& warnings = Listen();
  SchemaCache learned({.types = 2, .text = 10'000});
  EXPECT_TRUE(learned.Learn(Type("number.One")));
  EXPECT_TRUE(learned.Learn(Type("number.One")));
  EXPECT_TRUE(learned.Learn(Type("number.Two")));

  EXPECT_FALSE(learned.Learn(Type("number.Three")));
  EXPECT_FALSE(learned.Learn(Type("number.Four")));

  EXPECT_TRUE(learned.Learn(Type("number.Two"))) << "it is known";
  EXPECT_TRUE(FindSchema(Type("number.One").fingerprint()));
  EXPECT_TRUE(FindSchema(Type("number.Two").fingerprint()));
  EXPECT_FALSE(FindSchema(Type("number.Three").fingerprint()));
  EXPECT_FALSE(FindSchema(Type("number.Four").fingerprint()));
  EXPECT_THAT(warnings.values(), testing::ElementsAre(testing::HasSubstr("(2 types with ")));
}

TEST(SchemaCache, LimitsTheLengthOfTexts) {
  const std::size_t size = Type("text.One").TextWithHelp().size();
  SchemaCache learned({.types = 10, .text = 2 * size});
  EXPECT_TRUE(learned.Learn(Type("text.One")));

  EXPECT_FALSE(learned.Learn(Type("text." + std::string(size, 'A'))));

  EXPECT_TRUE(learned.Learn(Type("text.Two")));
  EXPECT_FALSE(learned.Learn(Type("text.Six")));
}

}  // namespace
