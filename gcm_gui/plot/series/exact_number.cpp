#include <gcm_gui/plot/series/exact_number.h>

#include <QLocale>

namespace tendon::gui {
namespace {

constexpr double kTwoTo63 = 9223372036854775808.0;

}  // namespace

QString ExactNumber::text() const {
  switch (kind_) {
    case Kind::kSigned:
      return QString::number(static_cast<qlonglong>(word_));
    case Kind::kUnsigned:
      return QString::number(static_cast<qulonglong>(word_));
    default:
      return QString::number(nearest(), 'g', QLocale::FloatingPointShortest);
  }
}

QString DifferenceText(const ExactNumber& from, const ExactNumber& to) {
  if (to.isBelow(from)) return '-' + QString::number(qulonglong{from.word() - to.word()});
  return QString::number(qulonglong{to.word() - from.word()});
}

DistanceFrom::DistanceFrom(ExactNumber::Kind kind, double base) : kind_(kind), base_(base) {
  if (kind == ExactNumber::Kind::kReal || base != std::floor(base)) return;
  const double end = kind == ExactNumber::Kind::kSigned ? kTwoTo63 : 2 * kTwoTo63;
  if (base == end) {
    whole_base_ = kind == ExactNumber::Kind::kSigned ? std::uint64_t{1} << 63 : 0;
    is_exact_ = is_beyond_ = true;
  } else if (kind == ExactNumber::Kind::kSigned && base >= -kTwoTo63 && base < kTwoTo63) {
    whole_base_ = static_cast<std::uint64_t>(static_cast<std::int64_t>(base));
    is_exact_ = true;
  } else if (kind == ExactNumber::Kind::kUnsigned && base >= 0 && base < 2 * kTwoTo63) {
    whole_base_ = static_cast<std::uint64_t>(base);
    is_exact_ = true;
  }
}

}  // namespace tendon::gui
