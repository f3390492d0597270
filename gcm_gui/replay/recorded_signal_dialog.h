#pragma once

#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/replay/replay_reader.h>

#include <QDialog>
#include <QSet>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QString>

class QLabel;
class QLineEdit;
class QPushButton;

namespace tendon::gui {

class RowView;

/// Lists the numbers in a recording, so that the user can choose some of them for a plot. The
/// numbers whose live curves are in the plot come first, and are selected. If the recording cannot
/// be opened, the dialog shows the reason. Deletes itself when it is closed.
class RecordedSignalDialog : public QDialog {
  Q_OBJECT

 public:
  /// `plotted` are the signals that the plot shows.
  RecordedSignalDialog(const QString& file, QSet<QString> plotted, QWidget* parent);

  /// The listed signals and the selected signals.
  [[nodiscard]] int count() const { return rows_.rowCount(); }
  [[nodiscard]] QList<CurveKey> selected() const;

 Q_SIGNALS:
  /// Emitted with the recorded paths of the chosen signals. `begin_ns` is the start of the
  /// recording in ns since 1970.
  void chosen(const QList<CurveKey>& keys, qint64 begin_ns);

 private:
  void build();
  void fill(const RecordingFacts& facts);
  void showState();
  void choose();

  const QString file_;
  const QSet<QString> plotted_;
  ReplayReader reader_{ReplayReader::Content::kRows};
  RecordingFacts facts_;
  QStandardItemModel rows_;
  QSortFilterProxyModel shown_;
  QLineEdit* filter_;
  RowView* list_ = nullptr;
  QLabel* status_;
  QPushButton* add_;
};

}  // namespace tendon::gui
