#pragma once

#include <gcm_gui/files/background.h>
#include <gcm_gui/files/gui_poster.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/system_reports.h>
#include <gcm_gui/system/snapshots.h>
#include <tendon/gcm/system/comparison.h>
#include <tendon/gcm/system/running_system.h>
#include <tendon/gcm/system_file.h>

#include <QObject>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace tendon::gui {

/// The system file of a window, and its differences from the running system. One thread reads and
/// writes files, another compares; everything else is in the GUI thread. Before a file is written,
/// the GCM is asked for the processes it has started.
class SystemDocument : public QObject {
  Q_OBJECT

 public:
  SystemDocument(const CatalogueStore& store, SystemReports& reports, QObject* parent = nullptr);
  /// Waits, for a limited time, for files that are being read or written. A requested save is
  /// executed even if the GCM has not answered yet.
  ~SystemDocument() override;

  [[nodiscard]] bool isOpen() const { return !path_.isEmpty(); }
  [[nodiscard]] const QString& path() const { return path_; }
  /// "demo.gcm.json".
  [[nodiscard]] QString name() const { return path_.section('/', -1); }
  [[nodiscard]] const SystemFile& file() const { return file_; }
  [[nodiscard]] const Catalogue& catalogue() const { return store_.catalogue(); }
  /// The comparison of the file with the running system.
  [[nodiscard]] const SystemComparison& comparison() const { return comparison_; }
  /// "demo.gcm.json", "demo.gcm.json, modified since 12:04"; empty without a file.
  [[nodiscard]] QString title() const;
  [[nodiscard]] const Snapshots& snapshots() const { return snapshots_; }

  /// Sets the positions of components in the graph, by path. From now on they are saved instead of
  /// those in the file.
  void setLayout(std::map<std::string, SystemFile::Position> layout);
  void open(const QString& path);
  /// Imports a file of the cisst component manager; components without a process go to `process`.
  /// Writes the result beside it as a system file; does nothing if that file already exists.
  void importFrom(const QString& path, const QString& process);
  /// Reads a system file, without making it this window's file.
  void read(const QString& path, std::function<void(const Result<SystemFile>&)> done);
  /// Saves the running system. Keeps other content of the file and, in an imported file, the parts
  /// that do not run yet.
  void save(const QString& path);
  /// Updates one item of the file to its running state; `what` names it as SystemDifference does.
  void update(const std::string& what);

 Q_SIGNALS:
  void changed();
  /// Emitted after open(), when the file was read.
  void opened();
  /// A sentence about the outcome.
  void notice(const QString& sentence);

 private:
  void onCatalogueChanged();
  /// Compares soon with the running system; again if something has changed meanwhile.
  void compare();
  void show(SystemComparison comparison);
  /// Makes `file` the window's file when it was compared; then calls `done`.
  void take(const QString& path, const SystemFile& file, std::function<void()> done);

  /// The processes started by the GCM; empty if the GCM is too old to report them, which `note`
  /// then says.
  struct StartedProcesses {
    message::Children children;
    QString note;
  };
  /// Empty if the answer is any other error; then notice() is emitted, and nothing is written.
  std::optional<StartedProcesses> startedBy(const Result<message::Children>& answer);
  void write(const QString& path, const StartedProcesses& started);
  void writePart(const std::string& what, const StartedProcesses& started);

  const CatalogueStore& store_;
  SystemReports& reports_;
  QString path_;
  QString imported_;     // the path of an imported file that was not opened again
  QStringList unsaved_;  // files to be written after the GCM's answer
  SystemFile file_;
  SystemComparison comparison_;
  std::int64_t modified_ = 0;  // ns since 1970; 0 while it equals the file
  Snapshots snapshots_;
  std::optional<std::map<std::string, SystemFile::Position>> layout_;
  QTimer soon_;
  bool is_comparing_ = false;
  bool is_behind_ = false;     // must be compared again
  std::uint64_t version_ = 0;  // version of file_
  std::shared_ptr<GuiPoster> poster_;
  Background thread_{QT_TRANSLATE_NOOP("Words", "a system file")};
  Background comparing_{QT_TRANSLATE_NOOP("Words", "the comparison with a system file")};
};

}  // namespace tendon::gui
