#include <gcm_console/feeds/curve_feed.h>

#include <utility>

namespace console {
namespace {

using tendon::NumericField;
using tendon::Result;

/// Returns true if `path` is equal to `whole` or is a part of it.
bool IsWithin(const std::string& path, const std::string& whole) {
  return path.starts_with(whole) &&
         (path.size() == whole.size() || path[whole.size()] == '.' || path[whole.size()] == '[');
}

/// Returns the number at this path; if it is not a number, all numbers below it.
Result<std::vector<NumericField>> NumbersOf(const tendon::Schema& schema, const std::string& path) {
  auto one = tendon::FindNumericField(schema, path);
  if (one) return std::vector{*std::move(one)};
  std::vector<NumericField> all = tendon::NumericFields(schema);
  std::erase_if(all, [&](const NumericField& field) { return !IsWithin(field.path, path); });
  if (all.empty()) return one.error();
  return all;
}

}  // namespace

void CurveFeed::OnSubscribed(const std::vector<tendon::Schema>& columns) {
  const std::scoped_lock lock(mutex_);
  is_subscribed_ = true;
  sources_.clear();
  curves_.clear();
  left_out_.clear();
  complaint_.clear();
  for (const auto& wanted : wanted_) Add(wanted, columns.at(wanted.column));
}

void CurveFeed::Add(const RowInbox::WantedPath& wanted, const tendon::Schema& schema) {
  const auto numbers = NumbersOf(schema, wanted.path.field);
  if (!numbers) {
    const std::string why = ToString(wanted.path) + ": " + numbers.error().message;
    if (wanted.is_found) return left_out_.push_back(why);
    mistake_ = tendon::Error{numbers.error().code, why};
    return;
  }
  tendon::Path title = wanted.path;
  for (const NumericField& number : *numbers) {
    title.field = number.path;
    if (curves_.size() == kMaxCurves) {
      return left_out_.push_back(ToString(title) + " and later numbers are left out: at most " +
                                 std::to_string(kMaxCurves) + " numbers of a table can be drawn");
    }
    sources_.push_back({wanted.column, number});
    curves_.push_back({ToString(title), number.unit, number.schema, {}});
  }
}

void CurveFeed::OnRows(const tendon::RowBatch& batch) {
  constexpr double kNanosecond = 1e-9;
  const std::scoped_lock lock(mutex_);
  for (std::size_t row = 0; row < batch.count; ++row) {
    const double time = static_cast<double>(batch.times[row]) * kNanosecond;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      auto& samples = curves_[i].samples;
      // If the time has gone back, the source was restarted.
      if (!samples.empty() && time < samples.back().time) samples.clear();
      samples.push_back(
          {time, ReadExactly(sources_[i].field, batch.cell(row, sources_[i].column))});
    }
  }
  for (NumberCurve& curve : curves_) {
    auto& samples = curve.samples;
    while (!samples.empty() && samples.back().time - samples.front().time > window_) {
      samples.pop_front();
    }
    if (samples.size() <= kMaxSamples) continue;
    is_cut_ = true;
    samples.erase(samples.begin(), samples.end() - kMaxSamples);
  }
}

void CurveFeed::OnStale(const tendon::Error& reason) {
  const std::scoped_lock lock(mutex_);
  complaint_ = reason.message;
}

std::vector<NumberCurve> CurveFeed::curves() const {
  const std::scoped_lock lock(mutex_);
  return curves_;
}

std::optional<tendon::Error> CurveFeed::mistake() const {
  const std::scoped_lock lock(mutex_);
  return mistake_;
}

bool CurveFeed::is_empty() const {
  const std::scoped_lock lock(mutex_);
  return is_subscribed_ && curves_.empty();
}

std::vector<std::string> CurveFeed::notes() const {
  const std::scoped_lock lock(mutex_);
  std::vector<std::string> notes = left_out_;
  if (is_cut_) {
    notes.push_back(
        "the newest " + std::to_string(kMaxSamples) +
        " samples of each curve are drawn; to see the whole window, use a shorter --window");
  }
  if (!complaint_.empty()) notes.push_back(complaint_);
  return notes;
}

}  // namespace console
