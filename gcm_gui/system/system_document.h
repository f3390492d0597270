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
/// writes files, another thread compares; all other work is done in the GUI thread. Before a file
/// is written, the GCM is asked which processes it has started.
class SystemDocument : public QObject {
  Q_OBJECT

 public:
  SystemDocument(const CatalogueStore& store, SystemReports& reports, QObject* parent = nullptr);
  /// Waits for a limited time until all files are read or written. If the GCM has not answered yet,
  /// a requested save is executed without its reply.
  ~SystemDocument() override;

  [[nodiscard]] bool isOpen() const { return !path_.isEmpty(); }
  [[nodiscard]] const QString& path() const { return path_; }
  /// The name of the file without its folder: "demo.gcm.json".
  [[nodiscard]] QString name() const { return path_.section('/', -1); }
  [[nodiscard]] const SystemFile& file() const { return file_; }
  [[nodiscard]] const Catalogue& catalogue() const { return store_.catalogue(); }
  /// The comparison of the file with the running system.
  [[nodiscard]] const SystemComparison& comparison() const { return comparison_; }
  /// The title: "demo.gcm.json", or "demo.gcm.json, modified since 12:04"; empty without a file.
  [[nodiscard]] QString title() const;
  [[nodiscard]] const Snapshots& snapshots() const { return snapshots_; }

  /// Sets the positions of components in the graph, by path. From now on these positions are saved,
  /// instead of the positions in the file.
  void setLayout(std::map<std::string, SystemFile::Position> layout);
  void open(const QString& path);
  /// Imports a file of the cisst component manager and writes it as a system file into the same
  /// folder. Components without a process are assigned to `process`. If the system file already
  /// exists, nothing is written.
  void importFrom(const QString& path, const QString& process);
  /// Reads a system file without making it the file of this window.
  void read(const QString& path, std::function<void(const Result<SystemFile>&)> done);
  /// Saves the running system. All other contents of the file are kept. In an imported file, the
  /// parts that do not run yet are kept, too.
  void save(const QString& path);
  /// Changes one item of the file to its running state. `what` names the item as in
  /// SystemDifference.
  void update(const std::string& what);

 Q_SIGNALS:
  void changed();
  /// Emitted when the file of open() has been read.
  void opened();
  /// Emitted with one sentence about the result.
  void notice(const QString& sentence);

 private:
  void onCatalogueChanged();
  /// Compares the file with the running system in another thread. If something changes meanwhile,
  /// compares again.
  void compare();
  void show(SystemComparison comparison);
  /// Makes `file` the file of the window as soon as it is compared, and then calls `done`.
  void take(const QString& path, const SystemFile& file, std::function<void()> done);

  /// The processes that the GCM has started. Empty if the GCM is too old to report them; `note`
  /// then says so.
  struct StartedProcesses {
    message::Children children;
    QString note;
  };
  /// Returns the processes in `reply`. If the reply is an error other than an old GCM, emits
  /// notice() and returns no value; the caller then writes nothing.
  std::optional<StartedProcesses> startedBy(const Result<message::Children>& reply);
  void write(const QString& path, const StartedProcesses& started);
  void writePart(const std::string& what, const StartedProcesses& started);

  const CatalogueStore& store_;
  SystemReports& reports_;
  QString path_;
  QString imported_;     // path of an imported file; empty once a file is opened
  QStringList unsaved_;  // files that will be written after the GCM's reply
  SystemFile file_;
  SystemComparison comparison_;
  std::int64_t modified_ = 0;  // ns since 1970; 0 while file and running system are the same
  Snapshots snapshots_;
  std::optional<std::map<std::string, SystemFile::Position>> layout_;
  QTimer soon_;
  bool is_comparing_ = false;
  bool is_behind_ = false;     // another comparison is needed after the present one
  std::uint64_t version_ = 0;  // version of file_
  std::shared_ptr<GuiPoster> poster_;
  Background thread_{QT_TRANSLATE_NOOP("Words", "a system file")};
  Background comparing_{QT_TRANSLATE_NOOP("Words", "the comparison with a system file")};
};

}  // namespace tendon::gui
