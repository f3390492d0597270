#include <gcm_console/row_printer.h>
#include <tendon/payload/plot_channel.h>
#include <tendon/payload/json.h>

#include <nlohmann/json.hpp>
#include <utility>

namespace console {

void RowPrinter::OnSubscribed(const std::vector<tendon::Schema>& columns) {
  const std::scoped_lock lock(mutex_);
  schemas_ = columns;
}

void RowPrinter::OnRows(const tendon::RowBatch& batch) {
  const std::scoped_lock lock(mutex_);
  losses_.table += batch.lost_table;
  losses_.network += batch.lost_network;
  for (std::size_t row = 0; row < batch.count; ++row) {
    if (rows_.size() >= kMostWaiting) {
      ++losses_.viewer;
      continue;
    }
    PrintedRow printed{.time_ns = batch.times[row], .tick = batch.ticks[row], .values = {}};
    for (const Wanted& wanted : wanted_) {
      printed.values.emplace_back(ToString(wanted.path),
                                  Value(wanted, batch.cell(row, wanted.column)));
    }
    rows_.push_back(std::move(printed));
  }
}

void RowPrinter::OnStale(const tendon::Error& reason) {
  const std::scoped_lock lock(mutex_);
  complaint_ = reason.message;
}

std::deque<PrintedRow> RowPrinter::Take() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(rows_, {});
}

RowPrinter::Losses RowPrinter::losses() const {
  const std::scoped_lock lock(mutex_);
  return losses_;
}

std::string RowPrinter::TakeComplaint() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(complaint_, {});
}

std::string RowPrinter::Value(const Wanted& wanted, std::span<const std::byte> cell) const {
  const tendon::Schema& schema = schemas_.at(wanted.column);
  if (wanted.path.field.empty()) {
    const auto json = tendon::ToJson(schema, cell);
    return json ? *json : "null";
  }
  const auto channel = tendon::FindChannel(schema, wanted.path.field);
  const auto number = channel ? tendon::ReadChannel(*channel, cell) : std::nullopt;
  return number ? nlohmann::json(*number).dump() : "null";
}

}  // namespace console
