#pragma once

#include <gcm_gui/plot/csv/csv_table.h>

#include <QObject>
#include <QString>
#include <QThreadPool>

namespace tendon::gui {

/// Writes tables to files in a thread of its own, one after the other. A file is there whole or not
/// at all.
class CsvExport : public QObject {
  Q_OBJECT

 public:
  explicit CsvExport(QObject* parent = nullptr);
  /// Waits for what is being written.
  ~CsvExport() override;

  void save(CsvTable table, const QString& file);

 Q_SIGNALS:
  /// One sentence for the user: what was saved, or why not.
  void finished(const QString& sentence);

 private:
  QThreadPool thread_;
};

}  // namespace tendon::gui
