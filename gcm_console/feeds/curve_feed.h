#pragma once

#include <gcm_console/feeds/row_inbox.h>
#include <tendon/payload/numeric_field.h>
#include <tendon/process/telemetry_client.h>

#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace console {

/// One number over the last seconds.
struct Curve {
  struct Sample {
    double time = 0.0;                          ///< s on the source's clock
    std::optional<tendon::NumericValue> value;  ///< empty if the row has no value
  };
  std::string title;
  std::string unit;
  tendon::Schema schema;       ///< of the number
  std::deque<Sample> samples;  ///< in the order of time
};

/// Receives the chosen numbers of one table. A path that names several numbers, such as a vector,
/// gives several curves. Thread-safe.
class CurveFeed final : public tendon::RowSink {
 public:
  /// Further curves are dropped.
  static constexpr std::size_t kMostCurves = 16;
  /// Per curve; when it is full, the oldest samples are dropped.
  static constexpr std::size_t kMostSamples = std::size_t{1} << 17U;

  /// `window` is the kept time span in s.
  CurveFeed(std::vector<RowInbox::Wanted> wanted, double window)
      : wanted_(std::move(wanted)), window_(window) {}

  void OnSubscribed(const std::vector<tendon::Schema>& columns) override;
  void OnRows(const tendon::RowBatch& batch) override;
  void OnStale(const tendon::Error& reason) override;

  [[nodiscard]] std::vector<Curve> curves() const;
  /// Set if a path that was not found by a glob is not a number.
  [[nodiscard]] std::optional<tendon::Error> mistake() const;
  /// True if every path is left out.
  [[nodiscard]] bool is_empty() const;
  /// The omitted paths with the reasons, then the reason of a present interruption.
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  struct Source {
    std::size_t column = 0;
    tendon::NumericField field;
  };
  void Add(const RowInbox::Wanted& wanted, const tendon::Schema& schema);

  const std::vector<RowInbox::Wanted> wanted_;
  const double window_;
  mutable std::mutex mutex_;
  bool is_subscribed_ = false;
  std::vector<Source> sources_;
  std::vector<Curve> curves_;  // curves of each source
  std::optional<tendon::Error> mistake_;
  std::vector<std::string> left_out_;
  std::string complaint_;
  bool is_cut_ = false;  // the window holds more samples than kMostSamples
};

}  // namespace console
