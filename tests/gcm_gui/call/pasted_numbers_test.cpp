#include <gcm_gui/call/pasted_numbers.h>
#include <gtest/gtest.h>

namespace tendon::gui {
namespace {

TEST(PastedNumbers, AreSplitAtUnambiguousSeparators) {
  const QStringList three{"0.1", "-2", "3e1"};
  for (const QString text :
       {"0.1 -2 3e1", "0.1\t-2\t3e1", "0.1\n-2\n3e1\n", "0.1\r\n-2\r\n3e1", "0.1;-2;3e1",
        "0.1; -2; 3e1", "0.1, -2, 3e1", "[0.1, -2, 3e1]", "[0.1,-2,3e1]", "  [ 0.1 -2 3e1 ]  ",
        "0.1,\n-2,\n3e1", "0.1;\n-2;\n3e1", "[0.1, -2;3e1]"}) {
    const PastedNumbers copied = NumbersIn(text);
    EXPECT_TRUE(copied.is_list) << qPrintable(text);
    EXPECT_EQ(copied.words, three) << qPrintable(text) << qPrintable(copied.refusal);
  }
}

TEST(PastedNumbers, ASingleValueIsNoList) {
  for (const QString text :
       {"0.5", " 0.5 ", "0,5", "1.234,5", "1,234,567", "1\u00a0234,5", "5deg", "fast", "", " "}) {
    EXPECT_FALSE(NumbersIn(text).is_list) << qPrintable(text);
  }
  EXPECT_EQ(NumbersIn("[0.5]").words, QStringList{"0.5"});
}

TEST(PastedNumbers, ACommaWithoutABlankBelongsToItsNumber) {
  EXPECT_EQ(NumbersIn("0,1 0,2").words, (QStringList{"0,1", "0,2"}));
  EXPECT_EQ(NumbersIn("0,1;0,2").words, (QStringList{"0,1", "0,2"}));
  EXPECT_EQ(NumbersIn("0,1, 0,2").words, (QStringList{"0,1", "0,2"}));
  EXPECT_EQ(NumbersIn("[0,1; 0,2]").words, (QStringList{"0,1", "0,2"}));
}

TEST(PastedNumbers, AnAmbiguousListIsRejectedAsAWhole) {
  for (const QString text : {"0.1,0.2,0.3", "1,2,3,4,5", "1\t\t3", "1;;3", "1;2;", "[]", "[1,,2]",
                             "1 234", "12 345 678", "1 234.5", "-1 234,5", "1 234.", "1 234.5; 0.2",
                             "0.1\t1 234.5", "[0.1, 1 234.5]", "1 234\u00a0567.5", "1 234'567"}) {
    const PastedNumbers copied = NumbersIn(text);
    EXPECT_TRUE(copied.is_list) << qPrintable(text);
    EXPECT_TRUE(copied.words.isEmpty()) << qPrintable(text);
    EXPECT_FALSE(copied.refusal.isEmpty()) << qPrintable(text);
  }
}

}  // namespace
}  // namespace tendon::gui
