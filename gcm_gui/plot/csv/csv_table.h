#pragma once

#include <gcm_gui/plot/scaling/scaling.h>
#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/plot/series/sample_ring.h>

#include <QString>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

class QIODevice;

namespace tendon::gui {

/// The samples of some curves over a part of time, copied, so that another thread can write them.
struct CsvTable {
  struct Curve {
    QString path;
    QString unit;
    Scaling plotted = {};             ///< how the plot shows it; here it is as it came
    std::vector<std::int64_t> times;  ///< ns, on the source's steady clock
    ExactNumber::Kind kind = ExactNumber::Kind::kReal;
    std::vector<std::uint64_t> words;  ///< of this kind: see ExactNumber
    ValueNamesPointer names = {};      ///< of states, which are written by them
    std::vector<Gap> gaps;  ///< `index` counts in `times`: the gap is right before that sample
  };
  std::vector<Curve> curves;
  std::int64_t utc_offset_ns = 0;  ///< what makes a source's time one since 1970

  [[nodiscard]] bool empty() const;
};

/// Of the curves that are not hidden, the samples in [from_ns, to_ns].
[[nodiscard]] CsvTable CsvTableOf(const CurveSet& curves, std::int64_t from_ns, std::int64_t to_ns,
                                  std::int64_t utc_offset_ns);

struct CsvFigures {
  std::uint64_t rows = 0;
  std::uint64_t lost = 0;  ///< of all sources
};

/// One line for each moment at which there is a sample, in the order of time: seconds of the
/// source's clock, UTC, the curves (empty where one has no sample then), and for each state table
/// how many of its rows were lost right before, or "restart". Numbers are exact and as they came;
/// states are written by their names. The head says where a plot showed them scaled. Nothing when
/// the device refuses.
[[nodiscard]] std::optional<CsvFigures> WriteCsv(const CsvTable& table, QIODevice& device);

}  // namespace tendon::gui
