#include <gcm_console/feeds/row_inbox.h>

#include <tendon/gcm/client/json_field.h>
#include <tendon/payload/json.h>

#include <algorithm>
#include <utility>

namespace console {
namespace {

tendon::QueueBound BoundFor(tendon::RowDelivery delivery) {
  auto bound = kMaxWaiting;
  if (delivery == tendon::RowDelivery::kNewest) bound.elements = 1;
  return bound;
}

}  // namespace

std::size_t RowInbox::KeptRow::size() const {
  std::size_t bytes = sizeof(KeptRow);
  for (const auto& cell : cells) bytes += sizeof(cell) + cell.size();
  return bytes;
}

RowInbox::RowInbox(std::vector<WantedPath> wanted, tendon::RowDelivery delivery)
    : wanted_(std::move(wanted)), delivery_(delivery), rows_(BoundFor(delivery)) {}

void RowInbox::OnSubscribed(const std::vector<tendon::Schema>& columns) {
  auto now = std::make_shared<Columns>();
  now->schemas = columns;
  now->is_left_out.assign(wanted_.size(), false);
  for (const WantedPath& wanted : wanted_) {
    const auto field = tendon::FindNumericField(columns.at(wanted.column), wanted.path.field);
    now->numbers.push_back(field ? std::optional(*field) : std::nullopt);
  }
  const std::scoped_lock lock(mutex_);
  columns_ = std::move(now);
  left_out_.clear();
}

void RowInbox::OnRows(const tendon::RowBatch& batch) {
  const std::scoped_lock lock(mutex_);
  if (!columns_) return;
  lost_ += batch.lost;
  for (std::size_t row = 0; row < batch.count; ++row) {
    KeptRow kept{.time_ns = batch.times[row],
                 .clock_offset_ns = batch.clock_offset.count(),
                 .tick = batch.ticks[row],
                 .lost_before = std::exchange(lost_, {}),
                 .columns = columns_,
                 .cells = {}};
    for (std::size_t column = 0; column < columns_->schemas.size(); ++column) {
      const auto cell = batch.cell(row, column);
      kept.cells.emplace_back(cell.begin(), cell.end());
    }
    tendon::LostRows gap;
    const std::size_t size = kept.size();
    rows_.Push(std::move(kept), size, [&](const KeptRow& oldest) {
      gap += oldest.lost_before;
      ++gap.viewer;
    });
    if (delivery_ == tendon::RowDelivery::kAll) rows_.front().lost_before += gap;
  }
}

void RowInbox::OnStale(const tendon::Error& reason) {
  const std::scoped_lock lock(mutex_);
  complaint_ = reason.message;
  interruption_ = reason;
}

std::deque<PrintedRow> RowInbox::Take() {
  std::unique_lock lock(mutex_);
  const std::deque<KeptRow> taken = rows_.Take(kMaxTaken);
  lock.unlock();  // so that new rows can be added meanwhile
  std::deque<PrintedRow> printed;
  for (const KeptRow& row : taken) {
    gap_ += row.lost_before;
    PrintedRow one{.time_ns = row.time_ns,
                   .clock_offset_ns = row.clock_offset_ns,
                   .tick = row.tick,
                   .lost_before = gap_,
                   .values = {}};
    if (!Fill(row, one)) continue;
    printed.push_back(std::move(one));
    gap_ = {};
  }
  return printed;
}

tendon::LostRows RowInbox::Rest() {
  const std::scoped_lock lock(mutex_);
  tendon::LostRows rest = std::exchange(gap_, {});
  while (!rows_.is_empty()) {
    for (const KeptRow& row : rows_.Take(kMaxTaken)) {
      rest += row.lost_before;
      if (delivery_ == tendon::RowDelivery::kAll) ++rest.viewer;
    }
  }
  rest += std::exchange(lost_, {});
  return rest;
}

bool RowInbox::Fill(const KeptRow& row, PrintedRow& printed) {
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    if (row.columns->is_left_out[i]) continue;
    auto value = Value(i, row);
    if (value) {
      printed.values.emplace_back(ToString(wanted_[i].path), *std::move(value));
      continue;
    }
    const std::scoped_lock lock(mutex_);
    if (wanted_[i].is_found) {
      row.columns->is_left_out[i] = true;
      left_out_.push_back(value.error().message);
    } else if (!mistake_) {
      mistake_ = value.error();
    }
  }
  return !mistake_ && !printed.values.empty();
}

bool RowInbox::has_more() const {
  const std::scoped_lock lock(mutex_);
  return !rows_.is_empty();
}

std::size_t RowInbox::waiting_bytes() const {
  const std::scoped_lock lock(mutex_);
  return rows_.bytes();
}

std::vector<std::string> RowInbox::TakeNotices() {
  const std::scoped_lock lock(mutex_);
  std::vector<std::string> all = std::exchange(left_out_, {});
  if (!complaint_.empty()) all.push_back(std::exchange(complaint_, {}));
  return all;
}

bool RowInbox::is_empty() const {
  const std::scoped_lock lock(mutex_);
  return columns_ && std::ranges::find(columns_->is_left_out, false) == columns_->is_left_out.end();
}

std::optional<tendon::Error> RowInbox::mistake() const {
  const std::scoped_lock lock(mutex_);
  return mistake_;
}

std::optional<tendon::Error> RowInbox::interruption() const {
  const std::scoped_lock lock(mutex_);
  return interruption_;
}

/// Returns the value at the path as JSON, usually a number. Returns "null" if this row does not
/// have the value.
tendon::Result<std::string> RowInbox::Value(std::size_t index, const KeptRow& row) const {
  const auto& [path, column, is_found] = wanted_[index];
  const auto& cell = row.cells.at(column);
  if (const auto& field = row.columns->numbers[index]) {
    const auto number = ReadExactly(*field, cell);
    return number ? ToJson(field->schema, *number) : "null";
  }
  auto json = tendon::ToJson(row.columns->schemas.at(column), cell);
  if (!json) return std::string("null");
  if (path.field.empty()) return json;
  auto part = tendon::client::JsonField(*json, path.field);
  if (part) return part;
  return tendon::Error{part.error().code, ToString(path) + ": " + part.error().message};
}

}  // namespace console
