#include <gcm_console/output/table.h>
#include <gtest/gtest.h>

#include <sstream>

namespace console {
namespace {

std::string Printed(int columns) {
  Table table({"PROCESS", "STATE", "ADDRESS"});
  table.Add({"robot", "alive", "127.0.0.1:41721"});
  table.Add({"a-desk-of-mine", "lost\n", ""});
  std::ostringstream out;
  table.Print(out, columns);
  return out.str();
}

TEST(Table, IsAlignedOnATerminal) {
  EXPECT_EQ(Printed(80),
            "PROCESS         STATE     ADDRESS\n"
            "robot           alive     127.0.0.1:41721\n"
            "a-desk-of-mine  lost\\x0a\n");
}

TEST(Table, IsSeparatedByTabsForScripts) {
  EXPECT_EQ(Printed(0), "robot\talive\t127.0.0.1:41721\na-desk-of-mine\tlost\\x0a\t\n");
}

TEST(Table, WrapsRowsAtTheTerminalWidth) {
  EXPECT_EQ(Printed(30),
            "PROCESS         STATE\n"
            "    ADDRESS\n"
            "robot           alive\n"
            "    127.0.0.1:41721\n"
            "a-desk-of-mine  lost\\x0a\n");
}

TEST(Table, AlignsNumbersAtTheRight) {
  Table table({"NAME", "PID", "WHERE"});
  table.Add({"robot", "7", "here"});
  table.Add({"desk", "12345", "-"});
  std::ostringstream out;
  table.Print(out, 80);
  EXPECT_EQ(out.str(),
            "NAME     PID  WHERE\n"
            "robot      7  here\n"
            "desk   12345  -\n");
}

TEST(Table, ColoursHaveNoWidthAndTitlesAreOptional) {
  Table table({"STATE", "NAME"});
  table.Add({"lost", "robot"});
  std::ostringstream out;
  table.Print(out, {.columns = 80, .is_coloured = true, .has_titles = false});
  EXPECT_EQ(out.str(), "\x1b[31mlost\x1b[0m   robot\n");
}

TEST(Table, IsColouredInAPipeOnRequest) {
  Table table({"STATE", "NAME"});
  table.Add({"lost", "robot"});
  std::ostringstream out;
  table.Print(out, {.columns = 0, .is_coloured = true});
  EXPECT_EQ(out.str(), "\x1b[31mlost\x1b[0m\trobot\n");
}

TEST(Table, IsPrintedOnTheNarrowestTerminal) { EXPECT_FALSE(Printed(1).empty()); }

TEST(PrintSentences, PrintsEachInALineWithEscapedControlCharacters) {
  std::ostringstream err;
  PrintSentences({"one", "two\x1b[2J"}, err);
  EXPECT_EQ(err.str(), "gcm: one\ngcm: " + Plain("two\x1b[2J") + "\n");
  EXPECT_EQ(err.str().find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace console
