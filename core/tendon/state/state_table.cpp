#include <tendon/state/state_table.h>

#include <tendon/base/name.h>

#include <algorithm>
#include <cassert>
#include <random>

namespace tendon {
namespace {

std::uint64_t RandomEpoch() {
  std::random_device device;
  return std::uint64_t{device()} << 32 | device();
}

/// A column whose variable is an encoded value.
class EncodedColumn final : public ColumnBase {
 public:
  EncodedColumn(const std::vector<std::byte>& body, const Schema& schema, std::string name,
                const CellLayout& layout)
      : ColumnBase(std::move(name), layout, schema, payload::Remember(schema)), body_(body) {}

 private:
  std::size_t EncodeVariable(std::span<std::byte> place) const noexcept override {
    if (body_.size() > place.size()) return 0;
    std::ranges::copy(body_, place.begin());
    return body_.size();
  }
  [[nodiscard]] const void* variable() const noexcept override { return &body_; }
  [[nodiscard]] const std::type_info& type() const noexcept override { return typeid(body_); }

  const std::vector<std::byte>& body_;
};

void LoadRow(const RowRing<>::Word* row, std::span<std::uint64_t> words) noexcept {
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = row[i].load(std::memory_order_relaxed);
}

}  // namespace

StateTable::StateTable(std::string name) : name_(std::move(name)), epoch_(RandomEpoch()) {
  RequireName("state table", name_);
}

void StateTable::SetLength(std::size_t rows) {
  if (!rows_.is_empty()) {
    throw ConfigurationError("state table '" + name_ +
                             "' already holds rows: its length cannot change; set it before the "
                             "component starts");
  }
  if (rows == 0 || rows > kMaximumLength) {
    throw ConfigurationError("state table '" + name_ + "' cannot keep " + std::to_string(rows) +
                             " rows: give 1 to " + std::to_string(kMaximumLength));
  }
  if (is_prepared_) rows_.Allocate(rows, row_words_);
  length_ = rows;
}

std::size_t StateTable::LengthFor(std::chrono::nanoseconds period, std::size_t row_bytes) noexcept {
  constexpr std::size_t kWord = sizeof(std::uint64_t);
  constexpr std::chrono::seconds kHistory(1);
  const auto cycles = period.count() > 0 ? kHistory / period : 0;
  return std::min(std::max(static_cast<std::size_t>(cycles), kMinimumLength),
                  RowRing<>::RowsWithin(kDefaultBytes / kWord, (row_bytes + kWord - 1) / kWord));
}

void StateTable::Prepare() {
  if (is_prepared_) return;
  row_.assign(row_words_, 0);
  rows_.Allocate(length_ == 0 ? LengthFor({}) : length_, row_words_);
  is_prepared_ = true;
}

void StateTable::SetFirstTick(std::uint64_t tick) {
  if (!rows_.is_empty()) {
    throw ConfigurationError("state table '" + name_ +
                             "' already holds rows: its first tick cannot change");
  }
  rows_.SetFirstTick(tick);
}

void StateTable::Advance(SteadyTime now) noexcept { AdvanceTo(next_tick(), now); }

void StateTable::AdvanceTo(std::uint64_t tick, SteadyTime now) noexcept {
  Prepare();
  for (const auto& filter : filters_) filter->Apply();
  rows_.BeginAt(tick, now.time_since_epoch().count());
  for (const auto& column : columns_) {
    const CellLayout& layout = column->layout();
    rows_.Store(layout.offset,
                column->Encode(std::span(row_).subspan(layout.offset, layout.words)));
  }
  rows_.Publish();
  last_ = now;
}

bool StateTable::IsTooEarly(SteadyTime now) const noexcept {
  return !rows_.is_empty() && now - last_ < interval_;
}

const ColumnBase* StateTable::Find(std::string_view name) const noexcept {
  const auto found = std::ranges::find(
      columns_, name, [](const auto& column) -> std::string_view { return column->name(); });
  return found == columns_.end() ? nullptr : found->get();
}

const ColumnBase& StateTable::Find(const void* variable, const std::type_info& type) const {
  for (const auto& column : columns_) {
    if (column->variable() == variable && column->type() == type) return *column;
  }
  throw ConfigurationError("the variable is not a column of state table '" + name_ +
                           "'; call Add() with the whole variable before you offer it");
}

RowResult StateTable::CopyRow(std::uint64_t tick, std::span<std::uint64_t> words,
                              std::int64_t& time_ns) const noexcept {
  assert(words.size() >= row_words_);
  return rows_.Read(tick, [&](const RowRing<>::Word* row) {
    LoadRow(row, words.first(row_words_));
    time_ns = RowRing<>::TimeOf(row);
  });
}

RowResult StateTable::CopyNewestRow(std::uint64_t& tick, std::span<std::uint64_t> words,
                                    std::int64_t& time_ns) const noexcept {
  assert(words.size() >= row_words_);
  return rows_.ReadNewest(tick, [&](const RowRing<>::Word* row) {
    LoadRow(row, words.first(row_words_));
    time_ns = RowRing<>::TimeOf(row);
  });
}

void StateTable::CheckColumn(const std::string& name, const void* variable,
                             const std::type_info& type, std::size_t bytes) const {
  RequireName("column", name);
  if (is_prepared_) throw AddedTooLate("column '" + name + "'", "state table '" + name_ + "'");
  const std::size_t taken = row_words_ * sizeof(std::uint64_t);
  if (bytes > kMaximumRowBytes || taken + bytes > kMaximumRowBytes) {
    throw ConfigurationError("column '" + name + "' of " + std::to_string(bytes) +
                             " bytes would make a row of state table '" + name_ + "' exceed " +
                             std::to_string(kMaximumRowBytes) +
                             " bytes; give it a smaller capacity, or send such values by an event");
  }
  for (const auto& column : columns_) {
    if (column->name() == name) {
      throw ConfigurationError("state table '" + name_ + "' has a column '" + name + "' already");
    }
    if (column->variable() == variable && column->type() == type) {
      throw ConfigurationError("the variable of column '" + name + "' is column '" +
                               column->name() + "' of state table '" + name_ + "' already");
    }
  }
}

void StateTable::AddEncoded(const std::vector<std::byte>& body, const Schema& schema,
                            std::string name, std::size_t capacity) {
  CheckColumn(name, &body, typeid(body), capacity);
  const CellLayout layout{
      .offset = row_words_, .words = (capacity + 7) / 8 + 1, .bytes = capacity, .is_dynamic = true};
  Append(std::make_unique<EncodedColumn>(body, schema, std::move(name), layout));
}

void StateTable::Append(std::unique_ptr<ColumnBase> column) {
  row_words_ += column->layout().words;
  columns_.push_back(std::move(column));
}

}  // namespace tendon
