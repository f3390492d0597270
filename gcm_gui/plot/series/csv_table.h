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

/// A copy of the samples of some curves in a time span, so that another thread can write them.
struct CsvTable {
  struct Curve {
    QString path;
    QString unit;
    Scaling plotted = {};       ///< the scaling in the plot; the values in the table are not scaled
    std::int64_t shift_ns = 0;  ///< of a recorded signal; already added to the times
    std::vector<std::int64_t> times;  ///< ns, on the source's steady clock
    ExactNumber::Kind kind = ExactNumber::Kind::kReal;
    std::vector<std::uint64_t> words;  ///< values of `kind`: see ExactNumber
    ValueNamesPointer names = {};      ///< names of the states; states are written by name
    std::vector<Gap> gaps;  ///< `index` is the index in `times` of the sample after the gap
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
  std::uint64_t lost = 0;  ///< rows lost by all sources together
};

/// Writes one line for each time that has a sample, in the order of time. The columns are: seconds
/// of the source's clock; UTC; one column for each curve, empty if it has no sample at that time;
/// and for each state table the number of rows lost directly before, or "restart". Numbers are
/// exact and not scaled; states are written by name. The header of the file names the scaling in
/// the plot and, for a recorded signal, its shift in time, which all times in the table
/// contain. Returns no value if writing to the device fails.
[[nodiscard]] std::optional<CsvFigures> WriteCsv(const CsvTable& table, QIODevice& device);

}  // namespace tendon::gui
