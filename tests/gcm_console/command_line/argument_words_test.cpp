#include <gcm_console/command_line/argument_words.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace console {
namespace {

using tendon::Schema;
using ArgumentList = std::vector<std::string>;

/// A structure of a text, an enumeration with two values, and a bool.
Schema SayingSchema() {
  const Schema tone = Schema::Enum("hall.Tone", {{"low", 0}, {"high", 1}});
  return Schema::Structure("hall.Saying",
                           {{.name = "text", .unit = "", .schema = Schema(Schema::Kind::kString)},
                            {.name = "tone", .unit = "", .schema = tone},
                            {.name = "loud", .unit = "", .schema = Schema(Schema::Kind::kBool)}});
}

std::string Told(const Schema& schema, const ArgumentList& words) {
  const auto argument = ArgumentOf(schema, "hall/crier/Voice.Say", words);
  return argument ? *argument : argument.error().message;
}

TEST(ArgumentWords, NameFieldsByOrderOrByName) {
  const std::string whole = R"({"text":"hi there","tone":"high","loud":true})";
  EXPECT_EQ(Told(SayingSchema(), {"hi there", "high", "true"}), whole);
  EXPECT_EQ(Told(SayingSchema(), {"loud=true", "\"hi there\"", "tone=\"high\""}),
            R"({"loud":true,"text":"hi there","tone":"high"})");
  EXPECT_EQ(Told(SayingSchema(), {whole}), whole);
}

TEST(ArgumentWords, AScalarTakesOneWord) {
  EXPECT_EQ(Told(Schema(Schema::Kind::kInt32), {"-3"}), "-3");
  EXPECT_EQ(Told(SayingSchema().fields()[1].schema, {"low"}), "\"low\"");
  EXPECT_EQ(Told(Schema::Sequence(Schema(Schema::Kind::kFloat64)), {"[1.5, 2]"}), "[1.5,2]");
  EXPECT_EQ(Told(Schema(Schema::Kind::kInt32), {"1", "2"}),
            "hall/crier/Voice.Say: '2' is one word too many: expected one value of type int32");
  EXPECT_EQ(Told(Schema(Schema::Kind::kInt32), {"many"}),
            "hall/crier/Voice.Say: the argument: expected int32, got 'many'; write a number in "
            "digits");
}

TEST(ArgumentWords, NumbersAreExactOrRejected) {
  const Schema real(Schema::Kind::kFloat64);
  const Schema integer(Schema::Kind::kInt64);
  const std::string begin = "hall/crier/Voice.Say: the argument: ";
  EXPECT_EQ(Told(real, {"-.5"}), "-0.5");
  EXPECT_EQ(Told(real, {".5"}), "0.5");
  EXPECT_EQ(Told(real, {"+1"}), "1");
  EXPECT_EQ(Told(real, {"-inf"}), "\"-inf\"");
  EXPECT_EQ(Told(real, {"nan"}), "\"nan\"");
  EXPECT_EQ(Told(integer, {"9223372036854775807"}), "9223372036854775807");
  EXPECT_EQ(Told(Schema(Schema::Kind::kDuration), {"2.5"}), "2.5");
  EXPECT_EQ(Told(Schema(Schema::Kind::kDuration), {"2000000000.123456789"}),
            "\"2000000000.123456789\"")
      << "a double would have other nanoseconds";
  EXPECT_EQ(Told(real, {"0,5"}),
            begin + "expected float64, got '0,5'; write 0.5: use a point as the decimal sign");
  EXPECT_EQ(Told(real, {"5deg"}),
            begin + "expected float64, got '5deg'; write the number alone, without 'deg'");
  EXPECT_EQ(
      Told(real, {"1e999"}),
      begin + "expected float64, got '1e999'; the number is too large or too small for the type");
  EXPECT_EQ(Told(integer, {"9223372036854775808"}),
            begin +
                "expected int64, got '9223372036854775808'; the number is too large or too small "
                "for the type");
  EXPECT_EQ(Told(integer, {"0x10"}), begin + "expected int64, got '0x10'; write 16");
  EXPECT_EQ(Told(integer, {"1.5"}), begin + "expected int64, got '1.5'; write a whole number");
}

TEST(ArgumentWords, ListsAreCheckedAsTyped) {
  const Schema integers = Schema::Sequence(Schema(Schema::Kind::kInt32));
  const Schema words = Schema::Structure(
      "hall.Words", {{.name = "a", .unit = "", .schema = Schema(Schema::Kind::kFloat64)}});
  EXPECT_EQ(Told(integers, {"[1, 2]"}), "[1,2]");
  EXPECT_THAT(Told(integers, {"[1.00000000000000000001]"}), testing::HasSubstr("[0]: expected an"));
  const Schema inner =
      Schema::Structure("hall.Outer", {{.name = "of", .unit = "", .schema = words}});
  EXPECT_THAT(Told(inner, {R"(of={"a":1,"a":2})"}), testing::HasSubstr("key 'a' occurs twice"));
}

TEST(ArgumentWords, MistakesListTheFields) {
  const std::string begin = "hall/crier/Voice.Say: ";
  const std::string fields = "hall.Saying has text, tone, loud";
  EXPECT_EQ(Told(SayingSchema(), {"hi", "high"}), begin + "loud is missing: " + fields);
  EXPECT_EQ(Told(SayingSchema(), {"hi", "high", "true", "7"}),
            begin + "'7' is one word too many: " + fields);
  EXPECT_EQ(Told(SayingSchema(), {"hi", "text=ho"}),
            begin + "text is given twice: leave out one of the two");
  EXPECT_EQ(Told(SayingSchema(), {"hi", "tune=high"}),
            begin + "no field 'tune'; did you mean 'tone'?");
  EXPECT_EQ(Told(SayingSchema(), {"a=1"}), begin + "no field 'a'; " + fields);
  EXPECT_EQ(Told(SayingSchema(), {"text=a=1", "high", "false"}),
            R"({"text":"a=1","tone":"high","loud":false})");
}

TEST(ArgumentWords, NextWordsAreTheRemainingFieldsAndValues) {
  EXPECT_EQ(NextWords(SayingSchema(), {}), (ArgumentList{"text=", "tone=", "tone=low", "tone=high",
                                                         "loud=", "loud=false", "loud=true"}));
  EXPECT_EQ(NextWords(SayingSchema(), {"hi", "loud=true"}),
            (ArgumentList{"low", "high", "tone=", "tone=low", "tone=high"}));
  EXPECT_EQ(NextWords(SayingSchema(), {"{}"}), ArgumentList{});
  EXPECT_EQ(NextWords(Schema(Schema::Kind::kBool), {}), (ArgumentList{"false", "true"}));
}

}  // namespace
}  // namespace console
