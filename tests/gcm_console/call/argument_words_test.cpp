#include <gcm_console/call/argument_words.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace console {
namespace {

using tendon::Schema;
using ArgumentList = std::vector<std::string>;

/// Of a text, a tone of two, and whether it is loud.
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

TEST(ArgumentWords, AreTheFieldsInTheirOrderOrByName) {
  const std::string whole = R"({"text":"hi there","tone":"high","loud":true})";
  EXPECT_EQ(Told(SayingSchema(), {"hi there", "high", "true"}), whole);
  EXPECT_EQ(Told(SayingSchema(), {"loud=true", "\"hi there\"", "tone=\"high\""}),
            R"({"loud":true,"text":"hi there","tone":"high"})");
  EXPECT_EQ(Told(SayingSchema(), {whole}), whole);
}

TEST(ArgumentWords, OfWhatIsNoStructureThereIsOne) {
  EXPECT_EQ(Told(Schema(Schema::Kind::kInt32), {"-3"}), "-3");
  EXPECT_EQ(Told(SayingSchema().fields()[1].schema, {"low"}), "\"low\"");
  EXPECT_EQ(Told(Schema::Sequence(Schema(Schema::Kind::kFloat64)), {"[1.5, 2]"}), "[1.5,2]");
  EXPECT_EQ(Told(Schema(Schema::Kind::kInt32), {"1", "2"}),
            "hall/crier/Voice.Say: '2' is one word too many: it takes one value of int32");
  EXPECT_THAT(Told(Schema(Schema::Kind::kInt32), {"many"}),
              testing::StartsWith("hall/crier/Voice.Say: the argument: expected int32 as JSON, got "
                                  "'many'"));
}

TEST(ArgumentWords, MistakesNameTheFieldsThatThereAre) {
  const std::string begin = "hall/crier/Voice.Say: ";
  const std::string fields = "hall.Saying has text, tone, loud";
  EXPECT_EQ(Told(SayingSchema(), {"hi", "high"}), begin + "loud is missing: " + fields);
  EXPECT_EQ(Told(SayingSchema(), {"hi", "high", "true", "7"}),
            begin + "'7' is one word too many: " + fields);
  EXPECT_EQ(Told(SayingSchema(), {"hi", "text=ho"}), begin + "text is given twice");
  EXPECT_EQ(Told(SayingSchema(), {"hi", "tune=high"}),
            begin + "no field 'tune'; did you mean 'tone'?");
  EXPECT_EQ(Told(SayingSchema(), {"a=1"}), begin + "no field 'a'; " + fields);
  EXPECT_EQ(Told(SayingSchema(), {"text=a=1", "high", "false"}),
            R"({"text":"a=1","tone":"high","loud":false})");
}

TEST(ArgumentWords, BehindSomeAreTheFieldsAndValuesThatAreLeft) {
  EXPECT_EQ(WordsBehind(SayingSchema(), {}),
            (ArgumentList{"text=", "tone=", "tone=low", "tone=high", "loud=", "loud=false",
                          "loud=true"}));
  EXPECT_EQ(WordsBehind(SayingSchema(), {"hi", "loud=true"}),
            (ArgumentList{"low", "high", "tone=", "tone=low", "tone=high"}));
  EXPECT_EQ(WordsBehind(SayingSchema(), {"{}"}), ArgumentList{});
  EXPECT_EQ(WordsBehind(Schema(Schema::Kind::kBool), {}), (ArgumentList{"false", "true"}));
}

}  // namespace
}  // namespace console
