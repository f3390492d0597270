#pragma once

#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/plot/series/sample_ring.h>
#include <gcm_gui/plot/series/scaling.h>

#include <QString>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

class QIODevice;

namespace tendon::gui {

/// A copy of some curves' samples in a time span, for writing in another thread.
struct CsvTable {
  struct Curve {
    QString path;
    QString unit;
    Scaling plotted = {};             ///< the scaling in the plot; the table is unscaled
    std::vector<std::int64_t> times;  ///< ns, on the source's steady clock
    ExactNumber::Kind kind = ExactNumber::Kind::kReal;
    std::vector<std::uint64_t> words;  ///< of `kind`: see ExactNumber
    ValueNamesPointer names = {};      ///< of states, which are written by name
    std::vector<Gap> gaps;  ///< `index` is an index into `times`; the gap is just before it
  };
  std::vector<Curve> curves;
  std::int64_t utc_offset_ns = 0;  ///< converts the source's time to a time since 1970

  [[nodiscard]] bool empty() const;
};

/// Copies the samples of the visible curves in [from_ns, to_ns].
[[nodiscard]] CsvTable CsvTableOf(const CurveSet& curves, std::int64_t from_ns, std::int64_t to_ns,
                                  std::int64_t utc_offset_ns);

struct CsvFigures {
  std::uint64_t rows = 0;
  std::uint64_t lost = 0;  ///< of all sources
};

/// Writes one line per time with a sample, in time order: seconds of the source's clock, UTC, the
/// curves (empty without a sample at that time), and for each state table the number of rows lost
/// just before, or "restart". Numbers are exact and unscaled; states are written by name. The
/// header of the file names the scaling in the plot. Returns no value if the device fails.
[[nodiscard]] std::optional<CsvFigures> WriteCsv(const CsvTable& table, QIODevice& device);

}  // namespace tendon::gui
