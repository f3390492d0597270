#include <gcm_console/command_line/command_line.h>
#include <gcm_console/shell/command_parser.h>
#include <gtest/gtest.h>

namespace console {
namespace {

using Commands = std::vector<Words>;

Commands Of(const std::string& line) {
  const auto commands = ParseCommands(line);
  EXPECT_TRUE(commands) << line;
  Commands all;
  if (!commands) return all;
  for (const ShellCommand& command : *commands) all.push_back(command.words);
  return all;
}

TEST(CommandParser, SplitsWordsAtBlanks) {
  EXPECT_EQ(Of(""), Commands{});
  EXPECT_EQ(Of("  ls \t robot/arm "), (Commands{{"ls", "robot/arm"}}));
}

TEST(CommandParser, ASemicolonEndsACommandAndAHashStartsAComment) {
  EXPECT_EQ(Of("cd robot; ls ;; tree # all; of it"), (Commands{{"cd", "robot"}, {"ls"}, {"tree"}}));
  EXPECT_EQ(Of("# nothing"), Commands{});
  EXPECT_EQ(Of("find a#b"), (Commands{{"find", "a#b"}}));
}

TEST(CommandParser, AnAmpersandMarksABackgroundCommand) {
  const std::vector<ShellCommand> expected = {{{"watch", "a/b/c.d"}, true}, {{"ls"}, false}};
  for (const char* line : {"watch a/b/c.d & ls", "watch a/b/c.d& & ls", "watch a/b/c.d &ls;"}) {
    const auto commands = ParseCommands(line);
    ASSERT_TRUE(commands);
    EXPECT_EQ(*commands, expected) << line;
  }
  EXPECT_EQ(Of("find 'a & b' c\\&d"), (Commands{{"find", "a & b", "c&d"}}));
}

TEST(CommandParser, IgnoresTheProgramNameBeforeAVerb) {
  EXPECT_EQ(Of("gcm ls robot; gcm tree & gcm"), (Commands{{"ls", "robot"}, {"tree"}, {"gcm"}}));
  EXPECT_EQ(Of("find gcm"), (Commands{{"find", "gcm"}}));
  EXPECT_EQ(ParsePartialCommand("gcm sho").words, Words{"sho"});
  EXPECT_EQ(ParsePartialCommand("gcm ").words, Words{""});
  EXPECT_EQ(ParsePartialCommand("gcm call {").words, (Words{"call", "{"}));
  EXPECT_EQ(ParsePartialCommand("gcm {").words, Words{"{"});
  EXPECT_EQ(ParsePartialCommand("gcm").words, Words{"gcm"});
}

TEST(CommandParser, QuotesAndBackslashesKeepWordsTogether) {
  EXPECT_EQ(Of(R"(find 'a; b' "c \" d" e\ f '')"),
            (Commands{{"find", "a; b", "c \" d", "e f", ""}}));
}

TEST(CommandParser, JsonNeedsNoQuotes) {
  EXPECT_EQ(Of(R"(call a/b.C {"position": [1, 2], "name": "x } ; y"}; ls)"),
            (Commands{{"call", "a/b.C", R"({"position": [1, 2], "name": "x } ; y"})"}, {"ls"}}));
  EXPECT_EQ(Of(R"(call a/b.C goal={"name": "x ; y"} list=[1, 2]; ls)"),
            (Commands{{"call", "a/b.C", R"(goal={"name": "x ; y"})", "list=[1, 2]"}, {"ls"}}));
  EXPECT_EQ(Of("watch state.Joints[0]"), (Commands{{"watch", "state.Joints[0]"}}));
}

TEST(CommandParser, RejectsUnclosedQuotesAndBrackets) {
  EXPECT_EQ(ParseCommands("ls 'a b").error().message, "the quote in column 4 is not closed");
  EXPECT_EQ(ParseCommands("call a {\"b\": [1").error().message,
            "the bracket in column 8 is not closed");
}

TEST(CommandParser, APartialLineEndsWithAnOpenWord) {
  EXPECT_EQ(ParsePartialCommand("").words, (Words{""}));
  EXPECT_EQ(ParsePartialCommand("ls").words, (Words{"ls"}));
  EXPECT_EQ(ParsePartialCommand("ls ").words, (Words{"ls", ""}));
  EXPECT_EQ(ParsePartialCommand("cd a; get b/c").words, (Words{"get", "b/c"}));
  EXPECT_EQ(ParsePartialCommand("cd a;").words, (Words{""}));
  EXPECT_EQ(ParsePartialCommand("get b/c").typed, "b/c");
  EXPECT_EQ(ParsePartialCommand("save my\\ ").typed, "my\\ ");
  EXPECT_EQ(ParsePartialCommand("save my\\ ").words, (Words{"save", "my "}));
}

TEST(CommandParser, QuotedWordsParseBackUnchanged) {
  for (const char* word :
       {"lab.json", "my lab; 'new'.json", "#1", "a#1", "a&b", "[old]", "a\\b\"c", "ä b"}) {
    EXPECT_EQ(Of("save " + QuoteWord(word)), (Commands{{"save", word}})) << word;
  }
  EXPECT_EQ(QuoteWord("lab.json"), "lab.json");
  EXPECT_EQ(QuoteWord("my lab"), "my\\ lab");
}

TEST(ResolvedPath, StartsAtTheCurrentPathOfTheShell) {
  EXPECT_EQ(ResolvedPath("robot/arm", "state.Joints"), "robot/arm/state.Joints");
  EXPECT_EQ(ResolvedPath("robot/arm/state", "Joints.position[0]"),
            "robot/arm/state.Joints.position[0]");
  EXPECT_EQ(ResolvedPath("robot/arm", "/desk"), "desk");
  EXPECT_EQ(ResolvedPath("robot/arm", ".."), "robot");
  EXPECT_EQ(ResolvedPath("robot/arm", "../../desk/old_arm"), "desk/old_arm");
  EXPECT_EQ(ResolvedPath("robot", "../.."), "");
  EXPECT_EQ(ResolvedPath("", "robot/arm/Control.Stop"), "robot/arm/Control.Stop");
}

}  // namespace
}  // namespace console
