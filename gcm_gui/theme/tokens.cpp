#include <gcm_gui/theme/tokens.h>

#include <array>
#include <cstddef>

namespace tendon::gui {
namespace {

struct Tones {
  QRgb dark;
  QRgb light;

  [[nodiscard]] QColor in(Appearance appearance) const {
    return QColor::fromRgb(appearance == Appearance::kDark ? dark : light);
  }
};

// One entry for each Token, in the same order.
constexpr std::array<Tones, kTokenCount> kColors{{
    {0xff14171c, 0xffeceff3},
    {0xff1b1f26, 0xffffffff},
    {0xff242a34, 0xfff4f6f8},
    {0xff2f3743, 0xffd8dde5},
    {0xffe6e9ef, 0xff1a2230},
    {0xff9aa5b5, 0xff566273},
    {0xff5aa2ff, 0xff0b63ce},
    {0xff0b1a2e, 0xffffffff},
    {0xff1c2f4a, 0xffe2edfb},
    {0xff46b985, 0xff127a4b},
    {0xffe3a94a, 0xff9a5b00},
    {0xffee706d, 0xffbf3430},
    {0xff7a8494, 0xff8a94a2},
}};

constexpr std::array<Tones, kCurveColorCount> kCurves{{
    {0xff56b4e9, 0xff0072b2},
    {0xffe69f00, 0xffc77700},
    {0xff2fbf95, 0xff00856a},
    {0xffd98cb8, 0xffb0508c},
    {0xfff0e442, 0xff857400},
    {0xffef7a45, 0xffc4481a},
    {0xff8f9bff, 0xff5b5bd6},
    {0xffb8c0cc, 0xff4f5b6b},
}};

}  // namespace

QColor ColorOf(Token token, Appearance appearance) {
  return kColors.at(static_cast<std::size_t>(token)).in(appearance);
}

QColor CurveColor(int index, Appearance appearance) {
  return kCurves.at(static_cast<std::size_t>(index) % kCurves.size()).in(appearance);
}

}  // namespace tendon::gui
