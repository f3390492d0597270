#include <gcm_console/row_printer.h>
#include <tendon/gcm/client/json_field.h>
#include <tendon/payload/json.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace console {

void RowPrinter::OnSubscribed(const std::vector<tendon::Schema>& columns) {
  const std::scoped_lock lock(mutex_);
  schemas_ = columns;
  numbers_.clear();
  is_left_out_.assign(wanted_.size(), false);
  left_out_.clear();
  for (const Wanted& wanted : wanted_) {
    const auto channel = tendon::FindChannel(columns.at(wanted.column), wanted.path.field);
    const bool is_float = channel && channel->schema.kind() == tendon::Schema::Kind::kFloat64;
    numbers_.push_back(is_float ? std::optional(*channel) : std::nullopt);
  }
}

std::size_t RowPrinter::OnRows(const tendon::RowBatch& batch) {
  const std::scoped_lock lock(mutex_);
  const std::size_t fit = std::min(batch.count, kMostWaiting - rows_.size());
  for (std::size_t row = 0; row < fit; ++row) {
    PrintedRow printed{.time_ns = batch.times[row],
                       .clock_offset_ns = batch.clock_offset.count(),
                       .tick = batch.ticks[row],
                       .values = {}};
    if (Fill(batch, row, printed)) rows_.push_back(std::move(printed));
  }
  return batch.count - fit;
}

bool RowPrinter::Fill(const tendon::RowBatch& batch, std::size_t row, PrintedRow& printed) {
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    if (is_left_out_[i]) continue;
    const auto value = Value(i, batch, row);
    if (value) {
      printed.values.emplace_back(ToString(wanted_[i].path), *value);
    } else if (wanted_[i].is_found) {
      is_left_out_[i] = true;
      left_out_.push_back(value.error().message);
    } else if (!mistake_) {
      mistake_ = value.error();
    }
  }
  return !mistake_ && !printed.values.empty();
}

void RowPrinter::OnStale(const tendon::Error& reason) {
  const std::scoped_lock lock(mutex_);
  complaint_ = reason.message;
  interruption_ = reason;
}

std::deque<PrintedRow> RowPrinter::Take() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(rows_, {});
}

std::vector<std::string> RowPrinter::TakeComplaints() {
  const std::scoped_lock lock(mutex_);
  std::vector<std::string> all = std::exchange(left_out_, {});
  if (!complaint_.empty()) all.push_back(std::exchange(complaint_, {}));
  return all;
}

bool RowPrinter::is_empty() const {
  const std::scoped_lock lock(mutex_);
  return !is_left_out_.empty() && std::ranges::find(is_left_out_, false) == is_left_out_.end();
}

std::optional<tendon::Error> RowPrinter::mistake() const {
  const std::scoped_lock lock(mutex_);
  return mistake_;
}

std::optional<tendon::Error> RowPrinter::interruption() const {
  const std::scoped_lock lock(mutex_);
  return interruption_;
}

/// A number, or whatever else the path names, as JSON; "null" for what is not there in this row.
tendon::Result<std::string> RowPrinter::Value(std::size_t index, const tendon::RowBatch& batch,
                                              std::size_t row) const {
  const auto& [path, column, is_found] = wanted_[index];
  const auto cell = batch.cell(row, column);
  if (const auto& channel = numbers_[index]) {
    const auto number = ReadChannel(*channel, cell);
    return number ? nlohmann::json(*number).dump() : "null";
  }
  const auto json = tendon::ToJson(schemas_.at(column), cell);
  if (!json) return std::string("null");
  auto part = tendon::client::JsonField(*json, path.field);
  if (part) return part;
  return tendon::Error{part.error().code, ToString(path) + ": " + part.error().message};
}

}  // namespace console
