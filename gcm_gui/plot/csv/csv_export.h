#pragma once

#include <gcm_gui/plot/csv/csv_table.h>

#include <QObject>
#include <QString>

namespace tendon::gui {

/// Writes tables to files, in the thread of the FileWriter. GUI thread.
class CsvExport : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  void save(CsvTable table, const QString& file);

 Q_SIGNALS:
  /// One sentence for the user: what was saved, or why not.
  void finished(const QString& sentence);
};

}  // namespace tendon::gui
