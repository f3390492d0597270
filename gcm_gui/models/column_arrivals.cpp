#include <gcm_gui/models/column_arrivals.h>

#include <algorithm>

namespace tendon::gui {

void ColumnArrivals::onValues(const QString& column, const ColumnValues& values) {
  Arrival& arrival = all_[column];
  // If the subscription has ended meanwhile, the new subscription counts its rows from 0.
  if (isLeft(column, arrival)) arrival = {};
  arrival.rate.onValues(values);
  arrival.written = values.time;
  arrival.time = clock_.Now();
}

bool ColumnArrivals::isLeft(const QString& column, const Arrival& arrival) const {
  return !watched_.contains(column) && clock_.Now() - arrival.time > kSilence;
}

QStringList ColumnArrivals::dropSilent() {
  all_.removeIf(
      [this](QHash<QString, Arrival>::iterator each) { return isLeft(each.key(), each.value()); });
  return all_.keys();
}

std::optional<double> ColumnArrivals::rate(const QString& column) const {
  constexpr double kMaxPeriods = 5;
  const auto it = all_.constFind(column);
  if (it == all_.constEnd() || it->rate.hz() <= 0) return std::nullopt;
  const std::chrono::duration<double> silence = clock_.Now() - it->time;
  const std::chrono::duration<double> usual(kMaxPeriods / it->rate.hz());
  const std::chrono::duration<double> limit = kSilence;
  if (silence > std::max(limit, usual)) return std::nullopt;
  return it->rate.hz();
}

double ColumnArrivals::usualRate(const QString& column) const {
  const auto it = all_.constFind(column);
  return it == all_.constEnd() ? 0 : it->rate.hz();
}

std::optional<std::int64_t> ColumnArrivals::age(const QString& column) const {
  const auto it = all_.constFind(column);
  if (it == all_.constEnd() || it->written == 0 || isLeft(column, *it)) return std::nullopt;
  const std::int64_t now = clock_.Now().time_since_epoch().count();
  return std::max<std::int64_t>(0, now - it->written);
}

}  // namespace tendon::gui
