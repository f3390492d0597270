#include <gcm_gui/plot/series/csv_export.h>

#include <gcm_gui/files/file_writer.h>
#include <gcm_gui/language/words.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace tendon::gui {
namespace {

QString Saved(const CsvFigures& figures, bool is_scaled, const QString& file) {
  const QString missing = figures.lost == 0
                              ? Words::tr("none lost")
                              : Words::tr("%1 lost rows are marked").arg(figures.lost);
  const QString saved = (figures.rows == 1 ? Words::tr("Saved %1 row, %2, to %3")
                                           : Words::tr("Saved %1 rows, %2, to %3"))
                            .arg(figures.rows)
                            .arg(missing, file);
  return is_scaled ? saved + Words::tr("; the values are not scaled") : saved;
}

}  // namespace

void CsvExport::save(CsvTable table, const QString& file) {
  const bool is_scaled =
      std::any_of(table.curves.begin(), table.curves.end(),
                  [](const CsvTable::Curve& curve) { return !curve.plotted.isNone(); });
  const auto figures = std::make_shared<std::optional<CsvFigures>>();
  const auto fill = [table = std::make_shared<const CsvTable>(std::move(table)),
                     figures](QIODevice& device) {
    *figures = WriteCsv(*table, device);
    return figures->has_value();
  };
  FileWriter::exports().write(
      file, fill, this, [this, file, figures, is_scaled](const QString& refusal) {
        if (!refusal.isEmpty()) {
          Q_EMIT finished(NotSaved(file, refusal));
        } else if (*figures) {  // no value if a newer request replaced this request before it began
          Q_EMIT finished(Saved(**figures, is_scaled, file));
        }
      });
}

}  // namespace tendon::gui
