#pragma once

#include <gcm_console/row_printer.h>
#include <tendon/payload/plot_channel.h>
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
    std::optional<tendon::ChannelValue> value;  ///< nothing where the row has none
  };
  std::string title;
  std::string unit;
  tendon::Schema schema;       ///< of the number
  std::deque<Sample> samples;  ///< in the order of time
};

/// The numbers that are wanted of one table. Where a path names several, a vector say, each is a
/// curve. Thread-safe.
class CurveFeed final : public tendon::RowSink {
 public:
  /// More are not kept.
  static constexpr std::size_t kMostCurves = 16;
  /// Of a curve; newer samples take the place of the oldest.
  static constexpr std::size_t kMostSamples = std::size_t{1} << 17U;

  /// `window`: s that are kept.
  CurveFeed(std::vector<RowPrinter::Wanted> wanted, double window)
      : wanted_(std::move(wanted)), window_(window) {}

  void OnSubscribed(const std::vector<tendon::Schema>& columns) override;
  std::size_t OnRows(const tendon::RowBatch& batch) override;
  void OnStale(const tendon::Error& reason) override;

  [[nodiscard]] std::vector<Curve> curves() const;
  /// That a path names no number, which no glob has found.
  [[nodiscard]] std::optional<tendon::Error> mistake() const;
  /// Whether all that was wanted is left out.
  [[nodiscard]] bool is_empty() const;
  /// What is left out and why, and then why there are no rows just now.
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  struct Source {
    std::size_t column = 0;
    tendon::PlotChannel channel;
  };
  void Add(const RowPrinter::Wanted& wanted, const tendon::Schema& schema);

  const std::vector<RowPrinter::Wanted> wanted_;
  const double window_;
  mutable std::mutex mutex_;
  bool is_subscribed_ = false;
  std::vector<Source> sources_;
  std::vector<Curve> curves_;  // of each source
  std::optional<tendon::Error> mistake_;
  std::vector<std::string> left_out_;
  std::string complaint_;
  bool is_cut_ = false;  // the window is too long for as many samples as come
};

}  // namespace console
