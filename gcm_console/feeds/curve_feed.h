#pragma once

#include <gcm_console/feeds/row_inbox.h>
#include <tendon/payload/numeric_field.h>
#include <tendon/process/telemetry_client.h>

#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace console {

/// The values of one number during the last seconds.
struct NumberCurve {
  struct Sample {
    double time = 0.0;                          ///< s, on the clock of the source
    std::optional<tendon::NumericValue> value;  ///< empty if the row has no value
  };
  std::string title;
  std::string unit;
  tendon::Schema schema;       ///< schema of the number
  std::deque<Sample> samples;  ///< sorted by time
};

/// Receives the chosen numbers of one table. If a path names several numbers, such as a vector,
/// each number has its own curve. Thread-safe.
class CurveFeed final : public tendon::RowSink {
 public:
  /// The maximum number of curves; further curves are left out.
  static constexpr std::size_t kMaxCurves = 16;
  /// The maximum number of samples of each curve; above it, the oldest samples are dropped.
  static constexpr std::size_t kMaxSamples = std::size_t{1} << 17U;

  /// `window` is the time span in s for which samples are kept.
  CurveFeed(std::vector<RowInbox::WantedPath> wanted, double window)
      : wanted_(std::move(wanted)), window_(window) {}

  void OnSubscribed(const std::vector<tendon::Schema>& columns) override;
  void OnRows(const tendon::RowBatch& batch) override;
  void OnStale(const tendon::Error& reason) override;

  [[nodiscard]] std::vector<NumberCurve> curves() const;
  /// Returns an error if a path that the user has typed without a glob does not name a number.
  [[nodiscard]] std::optional<tendon::Error> mistake() const;
  /// Returns true if all paths are left out.
  [[nodiscard]] bool is_empty() const;
  /// Returns the paths that are left out, each with the reason. If rows are interrupted now, also
  /// returns the reason of the interruption.
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  struct Source {
    std::size_t column = 0;
    tendon::NumericField field;
  };
  void Add(const RowInbox::WantedPath& wanted, const tendon::Schema& schema);

  const std::vector<RowInbox::WantedPath> wanted_;
  const double window_;
  mutable std::mutex mutex_;
  bool is_subscribed_ = false;
  std::vector<Source> sources_;
  std::vector<NumberCurve> curves_;  // the curves of each source
  std::optional<tendon::Error> mistake_;
  std::vector<std::string> left_out_;
  std::string complaint_;
  bool is_cut_ = false;  // true if the window contains more than kMaxSamples samples
};

}  // namespace console
