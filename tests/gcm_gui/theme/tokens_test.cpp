#include <gcm_gui/theme/tokens.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace tendon::gui {
namespace {

// WCAG 2.1: relative luminance and contrast.
double Luminance(const QColor& color) {
  const auto linear = [](float channel) {
    return channel <= 0.03928F ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
         0.0722 * linear(color.blueF());
}

double Contrast(const QColor& a, const QColor& b) {
  const double bright = std::max(Luminance(a), Luminance(b));
  const double dark = std::min(Luminance(a), Luminance(b));
  return (bright + 0.05) / (dark + 0.05);
}

class Tokens : public testing::TestWithParam<Appearance> {};

TEST_P(Tokens, TextIsReadableOnEverySurface) {
  for (const Token surface : {Token::kCanvas, Token::kPanel, Token::kRaised, Token::kSelection}) {
    for (const Token text :
         {Token::kText, Token::kDim, Token::kAccent, Token::kOk, Token::kWarning, Token::kBad}) {
      EXPECT_GE(Contrast(ColorOf(text, GetParam()), ColorOf(surface, GetParam())), 4.5)
          << "token " << static_cast<int>(text) << " on " << static_cast<int>(surface);
    }
  }
}

TEST_P(Tokens, TextOnTheAccentIsReadable) {
  EXPECT_GE(Contrast(ColorOf(Token::kOnAccent, GetParam()), ColorOf(Token::kAccent, GetParam())),
            4.5);
}

TEST_P(Tokens, StaleMarksContrastWithThePanel) {
  EXPECT_GE(Contrast(ColorOf(Token::kStale, GetParam()), ColorOf(Token::kPanel, GetParam())), 3);
}

TEST_P(Tokens, CurvesContrastWithThePanelAndEachOther) {
  std::set<QRgb> colors;
  for (int i = 0; i < kCurveColorCount; ++i) {
    const QColor color = CurveColor(i, GetParam());
    EXPECT_GE(Contrast(color, ColorOf(Token::kPanel, GetParam())), 3) << "curve " << i;
    colors.insert(color.rgb());
  }
  EXPECT_EQ(colors.size(), kCurveColorCount);
  EXPECT_EQ(CurveColor(kCurveColorCount, GetParam()), CurveColor(0, GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Themes, Tokens, testing::Values(Appearance::kDark, Appearance::kLight),
                         [](const auto& instance) {
                           return instance.param == Appearance::kDark ? "Dark" : "Light";
                         });

}  // namespace
}  // namespace tendon::gui
