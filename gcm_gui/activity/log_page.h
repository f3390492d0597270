#pragma once

#include <gcm_gui/activity/log_filter.h>
#include <gcm_gui/activity/log_model.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/system_reports.h>
#include <gcm_gui/session/system_requests.h>

#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QMenu;

namespace tendon::gui {

class RowView;

/// Shows the log of all processes, filtered by level and words. The log level of each process can
/// be set here.
class LogPage : public QWidget {
  Q_OBJECT

 public:
  LogPage(SystemReports& reports, const CatalogueStore& store, SystemActions& actions,
          QWidget* parent = nullptr);

  [[nodiscard]] const LogModel& log() const { return log_; }
  void focusFilter();

 Q_SIGNALS:
  /// Emitted when the user clicks the origin of a record.
  void pathChosen(const QString& path);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* buildBar();
  void fillLevels(QMenu& menu);
  void showCount();

  SystemReports& reports_;
  const CatalogueStore& store_;
  SystemActions& actions_;
  LogModel log_;
  LogFilter filter_;
  bool is_watching_ = false;

  QComboBox* level_;
  QLineEdit* words_;
  QLabel* count_;
  RowView* list_;
};

}  // namespace tendon::gui
