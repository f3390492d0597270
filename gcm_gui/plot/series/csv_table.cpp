#include <gcm_gui/plot/series/csv_table.h>

#include <QByteArray>
#include <QDateTime>
#include <QIODevice>
#include <QStringList>
#include <QTimeZone>
#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

namespace tendon::gui {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kMicrosecond = 1'000;
constexpr qsizetype kWrittenAtOnce = 1 << 16;  // bytes written at once
constexpr std::int64_t kNoTime = std::numeric_limits<std::int64_t>::max();

QByteArray CsvField(const QString& text) {
  if (!text.contains(',') && !text.contains('"') && !text.contains('\n')) return text.toUtf8();
  return '"' + QString(text).replace('"', "\"\"").toUtf8() + '"';
}

template <typename Number>
void AppendNumber(QByteArray& line, Number number) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  line.append(digits.data(), end - digits.data());
}

/// Returns the seconds before the decimal point. They are rounded down, so the digits after the
/// point are positive.
std::int64_t SecondsOf(std::int64_t ns) { return ns / kSecond - (ns % kSecond < 0 ? 1 : 0); }

void AppendFraction(QByteArray& line, std::int64_t fraction, int digits) {
  line.append('.').append(QByteArray::number(qlonglong{fraction}).rightJustified(digits, '0'));
}

/// Writes the lines of a table in the order of time.
class Writer {
 public:
  Writer(const CsvTable& table, QIODevice& device)
      : table_(table), device_(device), next_(table.curves.size(), 0), next_gap_(next_) {
    for (const auto& curve : table.curves) {
      const QString source = SourceOf(curve.path);
      if (!sources_.contains(source)) sources_.append(source);
      source_of_.push_back(static_cast<std::size_t>(sources_.indexOf(source)));
    }
  }

  std::optional<CsvFigures> Run() {
    AddHead();
    for (std::int64_t time = NextTime(); time != kNoTime; time = NextTime()) {
      AddLine(time);
      if (text_.size() >= kWrittenAtOnce && !Flush()) return std::nullopt;
    }
    if (!Flush()) return std::nullopt;
    return figures_;
  }

 private:
  struct Interruption {  // a gap or a restart of one source, directly before a line
    std::uint64_t lost = 0;
    bool restart = false;
  };

  void AddHead() {
    text_.append("time_s,utc_estimated");
    for (const auto& curve : table_.curves) {
      const QString unit = curve.unit.isEmpty() ? QString() : " [" + curve.unit + ']';
      const QString scaled = TextOf(curve.plotted);
      const QString plotted = scaled.isEmpty() ? QString() : " (raw; plotted " + scaled + ')';
      text_.append(',').append(CsvField(FullName(curve.path) + unit + ShiftOf(curve) + plotted));
    }
    for (const QString& source : sources_) {
      text_.append(',').append(CsvField(FullName(source) + " rows lost before"));
    }
    text_.append('\n');
  }

  // All curves of the table have the time of the plot. Therefore, the header of a recorded curve
  // describes how to compute the recorded time.
  static QString ShiftOf(const CsvTable::Curve& curve) {
    if (RecordingOf(curve.path).isEmpty()) return {};
    QByteArray seconds(curve.shift_ns < 0 ? "-" : "+");
    const std::int64_t size = curve.shift_ns < 0 ? -curve.shift_ns : curve.shift_ns;
    AppendNumber(seconds, size / kSecond);
    AppendFraction(seconds, size % kSecond, 9);
    return " (recorded; utc_estimated = recorded utc " + seconds + " s)";
  }

  [[nodiscard]] std::int64_t NextTime() const {
    std::int64_t time = kNoTime;
    for (std::size_t i = 0; i < next_.size(); ++i) {
      const auto& times = table_.curves[i].times;
      if (next_[i] < times.size()) time = std::min(time, times[next_[i]]);
    }
    return time;
  }

  void AddLine(std::int64_t time) {
    AppendNumber(text_, SecondsOf(time));
    AppendFraction(text_, time - SecondsOf(time) * kSecond, 9);
    text_.append(',');
    AddUtc(time + table_.utc_offset_ns);
    std::vector<Interruption> before(static_cast<std::size_t>(sources_.size()));
    for (std::size_t i = 0; i < next_.size(); ++i) {
      text_.append(',');
      const auto& curve = table_.curves[i];
      if (next_[i] == curve.times.size() || curve.times[next_[i]] != time) continue;
      NoteGap(i, before[source_of_[i]]);
      AddValue(curve, next_[i]++);
    }
    for (const Interruption& source : before) {
      text_.append(',');
      if (source.restart) text_.append("restart");
      if (source.lost > 0) AppendNumber(text_, source.lost);
      figures_.lost += source.lost;
    }
    text_.append('\n');
    ++figures_.rows;
  }

  void AddValue(const CsvTable::Curve& curve, std::size_t index) {
    const ExactNumber number(curve.kind, curve.words[index]);
    if (curve.names != nullptr) {
      text_.append(CsvField(curve.names->textOf(number)));
    } else if (number.kind() == ExactNumber::Kind::kSigned) {
      AppendNumber(text_, static_cast<std::int64_t>(number.word()));
    } else if (number.kind() == ExactNumber::Kind::kUnsigned) {
      AppendNumber(text_, number.word());
    } else {
      AppendNumber(text_, number.nearest());
    }
  }

  void NoteGap(std::size_t curve, Interruption& before) {
    const auto& gaps = table_.curves[curve].gaps;
    std::size_t& next = next_gap_[curve];
    if (next == gaps.size() || gaps[next].index != next_[curve]) return;
    const Gap& gap = gaps[next++];
    before.restart = before.restart || gap.cause == Gap::Cause::kRestart;
    before.lost = std::max(before.lost, gap.lost);
  }

  void AddUtc(std::int64_t time) {
    const std::int64_t second = SecondsOf(time);
    if (second != second_ || second_text_.isEmpty()) {
      second_ = second;
      second_text_ =
          QDateTime::fromSecsSinceEpoch(second, Qt::UTC).toString("yyyy-MM-ddTHH:mm:ss").toUtf8();
    }
    text_.append(second_text_);
    AppendFraction(text_, (time - second * kSecond) / kMicrosecond, 6);
    text_.append('Z');
  }

  bool Flush() {
    const bool written = device_.write(text_) == text_.size();
    text_.clear();
    return written;
  }

  const CsvTable& table_;
  QIODevice& device_;
  QStringList sources_;
  std::vector<std::size_t> source_of_;  // the source of each curve
  std::vector<std::size_t> next_;       // the index of the next sample of each curve
  std::vector<std::size_t> next_gap_;
  QByteArray text_;
  QByteArray second_text_;
  std::int64_t second_ = 0;
  CsvFigures figures_;
};

}  // namespace

bool CsvTable::empty() const {
  return std::all_of(curves.begin(), curves.end(),
                     [](const Curve& curve) { return curve.times.empty(); });
}

CsvTable CsvTableOf(const CurveSet& curves, std::int64_t from_ns, std::int64_t to_ns,
                    std::int64_t utc_offset_ns) {
  CsvTable table;
  table.utc_offset_ns = utc_offset_ns;
  for (const auto& curve : curves.curves()) {
    if (!curve->isVisible()) continue;
    const SampleRing& samples = curve->samples();
    CsvTable::Curve& copy = table.curves.emplace_back();
    copy.path = curve->path();
    copy.unit = curve->unit();
    copy.plotted = curve->scaling();
    copy.shift_ns = curve->shift();
    copy.kind = samples.kind();
    copy.names = curve->allNames();
    const std::uint64_t first = samples.lowerBound(from_ns);
    const std::uint64_t end = samples.lowerBound(to_ns + 1);
    copy.times.reserve(end - first);
    copy.words.reserve(end - first);
    for (std::uint64_t at = first; at < end;) {
      const SampleRing::Segment segment = samples.segment(at, end);
      copy.times.insert(copy.times.end(), segment.times.begin(), segment.times.end());
      copy.words.insert(copy.words.end(), segment.words.begin(), segment.words.end());
      at += segment.times.size();
    }
    for (Gap gap : samples.gaps()) {
      if (gap.index < first || gap.index >= end) continue;
      gap.index -= first;
      copy.gaps.push_back(gap);
    }
  }
  return table;
}

std::optional<CsvFigures> WriteCsv(const CsvTable& table, QIODevice& device) {
  return Writer(table, device).Run();
}

}  // namespace tendon::gui
