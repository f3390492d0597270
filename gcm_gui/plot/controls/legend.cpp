#include <gcm_gui/plot/controls/legend.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/theme.h>

#include <QGridLayout>
#include <algorithm>
#include <cmath>
#include <functional>

namespace tendon::gui {
namespace {

constexpr int kBetween = 12;  // between two rows side by side

}  // namespace

Legend::Legend(QWidget* parent) : QFrame(parent), grid_(new QGridLayout(this)) {
  setObjectName("legend");
  setAccessibleName(Words::tr("Legend"));
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setVerticalSpacing(0);
  grid_->setHorizontalSpacing(kBetween);
  grid_->setSizeConstraint(QLayout::SetFixedSize);
  hide();
  // The fonts may have changed. Removes all rows; the next setEntries() builds them again.
  connect(&Theme::instance(), &Theme::changed, this, [this] { makeRows(0); });
}

void Legend::setEntries(const std::vector<LegendEntry>& entries) {
  const auto same_path = [](const LegendRow* row, const LegendEntry& entry) {
    return row->entry().path == entry.path;
  };
  if (!std::equal(rows_.begin(), rows_.end(), entries.begin(), entries.end(), same_path)) {
    makeRows(entries.size());
    value_width_ = 0;
  }
  for (std::size_t i = 0; i < entries.size(); ++i) rows_[i]->setEntry(entries[i]);
  alignColumns();
  setVisible(!rows_.empty());
}

void Legend::makeRows(std::size_t count) {
  while (rows_.size() > count) {
    rows_.back()->deleteLater();
    rows_.back()->hide();
    grid_->removeWidget(rows_.back());
    rows_.pop_back();
    arranged_ = 0;
  }
  while (rows_.size() < count) {
    auto* row = new LegendRow(this);
    connect(row, &LegendRow::toggled, this, &Legend::toggled);
    connect(row, &LegendRow::removeRequested, this, &Legend::removeRequested);
    connect(row, &LegendRow::dragRequested, this, &Legend::dragRequested);
    connect(row, &LegendRow::remapRequested, this, &Legend::remapRequested);
    connect(row, &LegendRow::lookRequested, this, &Legend::lookRequested);
    rows_.push_back(row);
  }
}

void Legend::alignColumns() {
  const int name_width = widest(&LegendRow::nameWidth);
  value_width_ = std::max(value_width_, widest(&LegendRow::valueWidth));
  const int unit_width = widest(&LegendRow::unitWidth);
  for (LegendRow* row : rows_) row->setColumns(name_width, value_width_, unit_width);
  arrange();
}

void Legend::setRoom(int width) {
  if (width == room_) return;
  room_ = width;
  arrange();
}

void Legend::arrange() {
  if (rows_.empty()) return;
  const int across = std::max(1, (room_ + kBetween) / (rows_.front()->width() + kBetween));
  if (across != across_ || rows_.size() != arranged_) {
    across_ = across;
    arranged_ = rows_.size();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const int place = static_cast<int>(i);
      grid_->addWidget(rows_[i], place / across, place % across);
    }
  }
  adjustSize();
}

int Legend::widest(const std::function<int(const LegendRow&)>& width) const {
  int result = 0;
  for (const LegendRow* row : rows_) result = std::max(result, width(*row));
  return result;
}

QString LegendValue(double value, const AxisRange& range) {
  constexpr double kLargestFixed = 1e7;
  constexpr int kFewDigits = 6;
  constexpr int kMaxDigits = 17;
  constexpr int kTickSteps = 6;
  const double size = std::abs(value);
  const double span = range.span();
  if (!std::isfinite(value) || !std::isfinite(span)) {
    return QString::number(value, 'g', kFewDigits);
  }
  const double step = NiceStep(span, kTickSteps) / 100;
  if (size < kLargestFixed && span >= 1e-9) return QString::number(value, 'f', DecimalsOf(step));
  if (size == 0) return QStringLiteral("0");
  const int digits = static_cast<int>(std::floor(std::log10(size) - std::log10(step))) + 2;
  return QString::number(value, 'g', std::clamp(digits, kFewDigits, kMaxDigits));
}

}  // namespace tendon::gui
