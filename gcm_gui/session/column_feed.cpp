#include <gcm_gui/session/column_feed.h>

#include <gcm_gui/models/text.h>
#include <gcm_gui/views/raw_image.h>
#include <tendon/payload/json.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace tendon::gui {
namespace {

bool HasSequence(const Schema& schema) {
  switch (schema.kind()) {
    case Schema::Kind::kSequence:
      return true;
    case Schema::Kind::kArray:
      return HasSequence(schema.element());
    case Schema::Kind::kStructure:
      return std::any_of(schema.fields().begin(), schema.fields().end(),
                         [](const auto& field) { return HasSequence(field.schema); });
    default:
      return false;
  }
}

bool SameShape(const std::vector<NumericField>& a, const std::vector<NumericField>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const NumericField& x, const NumericField& y) { return x.path == y.path; });
}

/// Drops the oldest samples above the limit. Returns the number of dropped samples.
std::size_t DropOldest(std::vector<ColumnFeed::Run>& runs, std::size_t& waiting, std::size_t most) {
  if (waiting <= most) return 0;
  std::size_t dropped = 0;
  const std::size_t wanted = waiting - most;
  for (ColumnFeed::Run& run : runs) {
    const std::size_t some = std::min(wanted - dropped, run.samples.size());
    run.samples.erase(run.samples.begin(), run.samples.begin() + static_cast<std::ptrdiff_t>(some));
    dropped += some;
  }
  waiting -= dropped;
  return dropped;
}

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

ExactNumber NumberOf(const NumericField& field, std::span<const std::byte> body) {
  const auto value = ReadExactly(field, body);
  if (!value) return kNotANumber;
  // States are stored as signed integers, like the numbers in ValueNames.
  const bool is_state = field.schema.kind() == Schema::Kind::kBool;
  if (value->kind() == NumericValue::Kind::kSigned || is_state) {
    return ExactNumber::Signed(value->integer());
  }
  if (value->kind() == NumericValue::Kind::kUnsigned) {
    return ExactNumber::Unsigned(static_cast<std::uint64_t>(value->integer()));
  }
  return value->real();
}

ValueNamesPointer ValueNamesOf(const Schema& schema) {
  ValueNames names;
  if (schema.kind() == Schema::Kind::kBool) {
    names = {.type = QStringLiteral("bool"),
             .all = {{0, QStringLiteral("false")}, {1, QStringLiteral("true")}}};
  } else if (schema.kind() == Schema::Kind::kEnum) {
    names.type = ToQString(schema.name());
    for (const auto& one : schema.enumerators()) {
      names.all.push_back({one.value, ToQString(one.name)});
    }
    std::stable_sort(names.all.begin(), names.all.end(),
                     [](const auto& a, const auto& b) { return a.value < b.value; });
  } else {
    return nullptr;
  }
  return std::make_shared<const ValueNames>(std::move(names));
}

}  // namespace

void ColumnFeed::OnSubscribed(const std::vector<Schema>& columns) {
  const std::lock_guard lock(mutex_);
  if (columns.empty()) return;
  const bool is_healed = schema_.has_value();
  schema_ = columns.front();
  is_picture_ = DescribesImage(*schema_);
  varies_ = !is_picture_ && HasSequence(*schema_);
  shape_ = std::make_shared<const std::vector<NumericField>>(NumericFields(*schema_));
  if (is_healed) {  // the subscription was renewed
    newest_row_.clear();
    is_renewed_ = true;
  }
  fresh_ = true;
  stale_.reset();
  for (auto& [field_path, tap] : taps_) resolve(field_path, tap);
}

void ColumnFeed::resolve(const std::string& field_path, Tap& tap) const {
  if (!schema_) return;
  auto field = FindNumericField(*schema_, field_path);
  if (field.ok()) {
    tap.names = ValueNamesOf(field->schema);
    tap.field = std::move(*field);
    tap.stale.reset();
  } else {
    tap.field.reset();
    tap.stale = ToQString(field.error().message);
  }
}

void ColumnFeed::OnRows(const RowBatch& batch) {
  const std::lock_guard lock(mutex_);
  losses_ += batch.lost;
  if (!schema_ || batch.count == 0) return;
  const bool new_epoch = batch.epoch != epoch_;
  epoch_ = batch.epoch;
  std::size_t left_out = 0;
  for (auto& [field_path, tap] : taps_) left_out = std::max(left_out, feed(tap, batch, new_epoch));
  keepNewest(batch);
  rows_ += batch.count;
  losses_.viewer += left_out;
}

void ColumnFeed::keepNewest(const RowBatch& batch) {
  const auto row = batch.cell(batch.count - 1, 0);
  newest_row_.assign(row.begin(), row.end());
  newest_time_ = batch.times[batch.count - 1] - batch.clock_offset.count();
  fresh_ = true;
}

void ColumnFeed::takeInitialRow(const RowBatch& batch) {
  const std::lock_guard lock(mutex_);
  if (newest_row_.empty() && batch.count > 0) keepNewest(batch);
}

bool ColumnFeed::hasRow() {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  return lock && !newest_row_.empty();
}

bool ColumnFeed::lacksRow() {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  return lock && newest_row_.empty();
}

bool ColumnFeed::takeRenewed() {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  return lock && std::exchange(is_renewed_, false);
}

QString ColumnFeed::refusal() {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  return lock && stale_ ? *stale_ : QString();
}

RowLosses ColumnFeed::losses() {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (lock) known_losses_ = {losses_.table, losses_.network, losses_.viewer};
  return known_losses_;
}

std::size_t ColumnFeed::feed(Tap& tap, const RowBatch& batch, bool new_epoch) const {
  if (!tap.field) return 0;
  tap.stale.reset();
  if (new_epoch || tap.runs.empty()) tap.runs.push_back({new_epoch, {}});
  std::vector<Sample>& samples = tap.runs.back().samples;
  for (std::size_t row = 0; row < batch.count; ++row) {
    samples.push_back({batch.times[row] - batch.clock_offset.count(), batch.ticks[row],
                       NumberOf(*tap.field, batch.cell(row, 0))});
  }
  tap.waiting += batch.count;
  return DropOldest(tap.runs, tap.waiting, most_waiting_);
}

void ColumnFeed::OnStale(const Error& reason) {
  const std::lock_guard lock(mutex_);
  const bool not_there = reason.code == ErrorCode::kUnreachable;
  stale_ = not_there ? QString() : ToQString(reason.message);
  for (auto& [field_path, tap] : taps_) tap.stale = stale_;
}

void ColumnFeed::tap(const std::string& field_path) { order({field_path, true}); }

void ColumnFeed::untap(const std::string& field_path) { order({field_path, false}); }

void ColumnFeed::order(Order one) {
  orders_.push_back(std::move(one));
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (lock) executeOrders();
}

void ColumnFeed::executeOrders() {
  for (const auto& [field_path, is_wanted] : std::exchange(orders_, {})) {
    if (!is_wanted) {
      taps_.erase(field_path);
      continue;
    }
    const auto [it, added] = taps_.try_emplace(field_path);
    if (!added) continue;
    it->second.stale = stale_;
    resolve(field_path, it->second);
  }
}

ColumnFeed::NewSamples ColumnFeed::take(const std::string& field_path) {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock) return {};
  executeOrders();
  const auto it = taps_.find(field_path);
  if (it == taps_.end()) return {};
  Tap& tap = it->second;
  tap.waiting = 0;
  return {std::exchange(tap.runs, {}), std::exchange(tap.stale, std::nullopt),
          std::exchange(tap.names, std::nullopt)};
}

NumericFieldList ColumnFeed::shapeOf(const std::vector<std::byte>& row) {
  if (varies_ && !row.empty()) {
    auto fields = NumericFields(*schema_, row);
    if (!SameShape(fields, *shape_)) {
      shape_ = std::make_shared<const std::vector<NumericField>>(std::move(fields));
    }
  }
  return shape_;
}

std::optional<ColumnValues> ColumnFeed::takeValues() {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock) return std::nullopt;
  executeOrders();
  if (!schema_ || !std::exchange(fresh_, false)) return std::nullopt;
  ColumnValues values;
  values.fields = shapeOf(newest_row_);
  if (newest_row_.empty()) return values;
  values.rows = rows_;
  values.time = newest_time_;
  values.values.reserve(values.fields->size());
  for (const NumericField& field : *values.fields) {
    values.values.push_back(ReadExactly(field, newest_row_));
  }
  if (is_picture_) {
    if (auto picture = RawImageOf(*schema_, newest_row_)) {
      values.picture = std::make_shared<const RawImage>(*std::move(picture));
    }
  }
  if (values.fields->empty()) {
    if (const auto json = ToJson(*schema_, newest_row_); json.ok()) values.text = ToQString(*json);
  }
  return values;
}

}  // namespace tendon::gui
