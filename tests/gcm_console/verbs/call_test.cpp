#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include "gcm_console/system_fixture.h"

namespace {

using testing::HasSubstr;

/// The component `hall/crier` returns the text that it receives.
class CallTest : public SystemFixture {
 protected:
  void SetUp() override {
    home.Write("hall.json", R"({"version": 1, "name": "hall", "processes": [{"name": "hall",
        "components": [{"name": "crier", "class": "Crier", "library": "crier"}]}]})");
    StartGcm();
    hall = StartLcm("hall", (home.path() / "hall.json").string());
    ASSERT_TRUE(EventuallySays({"ls", "hall"}, "crier\tactive")) << hall->err();
  }
  void ExpectUsage(const Program::Words& words, const std::string& sentence) const {
    const Outcome outcome = Gcm(words);
    EXPECT_EQ(outcome.exit_code, program::kUsage) << outcome.out;
    EXPECT_THAT(outcome.err, HasSubstr(sentence));
  }

  static constexpr const char* kRepeat = "hall/crier/Voice.Repeat";
  std::unique_ptr<Program> hall;
};

TEST_F(CallTest, AcceptsArgumentFieldsAsWords) {
  const std::string same = "{\"text\":\"hi there\",\"tone\":\"high\",\"loud\":true}\n";

  EXPECT_EQ(Gcm({"call", kRepeat, "hi there", "high", "true"}).out, same);
  EXPECT_EQ(Gcm({"call", kRepeat, "loud=true", "tone=high", "text=hi there"}).out, same);
  EXPECT_EQ(Gcm({"call", kRepeat, same}).out, same);
  EXPECT_EQ(Gcm({"call", "hall/crier/Voice.Sing", "low"}).out, "\"low\"\n");
  EXPECT_EQ(Gcm({"call", "hall/crier/Voice.Sing", "\"low\""}).out, "\"low\"\n");
}

TEST_F(CallTest, ReadsJsonFromStandardInput) {
  const std::string words = std::string("call ") + kRepeat + " --json -";
  const Outcome outcome =
      RunProgram({"/bin/sh", "-c",
                  R"(echo '{"text": "hi", "tone": "low", "loud": false}' | )" + Binary("gcm") +
                      " --gcm " + address + " --timeout " + kTestTimeout + " " + words});

  EXPECT_EQ(outcome.exit_code, program::kOk) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\"schema\": 1"));
  EXPECT_THAT(outcome.out, HasSubstr("\"tone\": \"low\""));
}

TEST_F(CallTest, RejectsWordsThatMatchNoFieldBeforeTheCall) {
  ExpectUsage({"call", kRepeat, "hi"}, "tone is missing: hall.Saying has text, tone, loud");
  ExpectUsage({"call", kRepeat, "hi", "high", "true", "7"}, "'7' is one word too many");
  ExpectUsage({"call", kRepeat, "hi", "tune=high"}, "no field 'tune'; did you mean 'tone'?");
  ExpectUsage({"call", kRepeat, "hi", "shrill", "true"}, "tone: expected ");
  ExpectUsage({"call", kRepeat, "hi", "high", "yes"}, "loud: expected bool as JSON, got 'yes'");
  ExpectUsage({"call", "hall/crier/Voice.Cry", "1", "2"}, "'2' is one word too many");
  ExpectUsage({"call", "hall/crier/Voice.Fall", "1", "2"}, "Voice.Fall takes no argument");
  EXPECT_EQ(Gcm({"call", "hall/crier/Voice.Repaet", "hi", "ho"}).exit_code, program::kNotFound);
}

/// CLI11 must not interpret brackets or a minus sign at the beginning of a word.
TEST_F(CallTest, PassesTextFieldsUnchanged) {
  for (const std::string text : {"[abc]", "[a, b]", "[1,2]", "-inf", "hi ", " hi", "[abc] "}) {
    EXPECT_EQ(Gcm({"call", kRepeat, text, "high", "true"}).out,
              "{\"text\":\"" + text + "\",\"tone\":\"high\",\"loud\":true}\n");
  }
}

TEST_F(CallTest, TheShellAcceptsArgumentWords) {
  const Outcome outcome = RunProgram(
      {"/bin/sh", "-c",
       std::string(R"(printf 'call )") + kRepeat + R"( text="hi" low loud=true' | )" +
           Binary("gcm") + " --gcm " + address + " --timeout " + kTestTimeout + " shell"});

  EXPECT_EQ(outcome.out, "{\"text\":\"hi\",\"tone\":\"low\",\"loud\":true}\n") << outcome.err;
}

}  // namespace
