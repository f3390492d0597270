#pragma once

#include <gcm_gui/plot/series/csv_table.h>

#include <QObject>
#include <QString>

namespace tendon::gui {

/// Writes tables to files in the FileWriter's thread. GUI thread.
class CsvExport : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  void save(CsvTable table, const QString& file);

 Q_SIGNALS:
  /// Emitted with one sentence for the user: the name of the saved file, or why saving failed.
  void finished(const QString& sentence);
};

}  // namespace tendon::gui
