#include <gcm_gui/plot/csv/csv_export.h>

#include <QSaveFile>
#include <memory>
#include <utility>

namespace tendon::gui {
namespace {

QString Save(const CsvTable& table, const QString& name) {
  QSaveFile file(name);
  const auto refusal = [&] {
    return QString("%1 could not be saved: %2").arg(name, file.errorString());
  };
  if (!file.open(QIODevice::WriteOnly)) return refusal();
  const auto figures = WriteCsv(table, file);
  if (!figures || !file.commit()) return refusal();
  const QString missing =
      figures->lost == 0 ? QString("none lost") : QString("%1 lost ones marked").arg(figures->lost);
  return QString("Saved %1 rows, %2, to %3").arg(figures->rows).arg(missing, name);
}

}  // namespace

CsvExport::CsvExport(QObject* parent) : QObject(parent) { thread_.setMaxThreadCount(1); }

CsvExport::~CsvExport() { thread_.waitForDone(); }

void CsvExport::save(CsvTable table, const QString& file) {
  const auto shared = std::make_shared<const CsvTable>(std::move(table));
  thread_.start([this, shared, file] {
    const QString sentence = Save(*shared, file);
    QMetaObject::invokeMethod(
        this, [this, sentence] { Q_EMIT finished(sentence); }, Qt::QueuedConnection);
  });
}

}  // namespace tendon::gui
