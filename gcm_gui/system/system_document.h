#pragma once

#include <gcm_gui/files/background.h>
#include <gcm_gui/reports/system_reports.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/courier.h>
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

/// The system file of a window, and in what the running system differs from it. Files are read and
/// written in a thread of its own, and compared in another; all else is of the GUI thread. Before
/// one is written the GCM is asked whom it has started.
class SystemDocument : public QObject {
  Q_OBJECT

 public:
  SystemDocument(const CatalogueStore& store, SystemReports& reports, QObject* parent = nullptr);
  /// Waits for what is being read or written, though not for ever; what was to be saved is, though
  /// the GCM has not yet said whom it has started.
  ~SystemDocument() override;

  [[nodiscard]] bool isOpen() const { return !path_.isEmpty(); }
  [[nodiscard]] const QString& path() const { return path_; }
  /// "demo.gcm.json".
  [[nodiscard]] QString name() const { return path_.section('/', -1); }
  [[nodiscard]] const SystemFile& file() const { return file_; }
  [[nodiscard]] const Catalog& catalogue() const { return store_.catalogue(); }
  /// Of the file with what runs.
  [[nodiscard]] const SystemComparison& comparison() const { return comparison_; }
  /// "demo.gcm.json", "demo.gcm.json, modified since 12:04"; empty without a file.
  [[nodiscard]] QString title() const;
  [[nodiscard]] const Snapshots& snapshots() const { return snapshots_; }

  /// Where components stand in the graph, by path: from now on it is saved with what runs, in place
  /// of what the file says about it.
  void setLayout(std::map<std::string, SystemFile::Position> layout);
  void open(const QString& path);
  /// The same with a file of the cisst component manager; what names no process goes to `process`.
  /// It is written beside that file, as a system file; where there is one already, nothing is done.
  void importFrom(const QString& path, const QString& process);
  /// Reads a system file that is not this window's.
  void read(const QString& path, std::function<void(const Result<SystemFile>&)> done);
  /// Writes down what runs; what the file knows besides is kept in it. So is, in a file that was
  /// imported, what does not run yet.
  void save(const QString& path);
  /// One thing of the file becomes as it runs; `what` is that of a SystemDifference.
  void update(const std::string& what);

 Q_SIGNALS:
  void changed();
  /// After open(), once it is read.
  void opened();
  /// One sentence of what came of it.
  void told(const QString& sentence);

 private:
  void hear();
  /// Soon, with what runs now; once more where something has changed meanwhile.
  void compare();
  void show(SystemComparison comparison);
  /// Is the window's file from the moment on when it has been compared; then `done` is called.
  void take(const QString& path, const SystemFile& file, std::function<void()> done);

  /// Whom the GCM has started; nobody where it is too old to say, which `note` tells.
  struct Started {
    message::Children children;
    QString note;
  };
  /// What else it answers is told, and nothing is to be written.
  std::optional<Started> startedBy(const Result<message::Children>& answer);
  void write(const QString& path, const Started& started);
  void writePart(const std::string& what, const Started& started);

  const CatalogueStore& store_;
  SystemReports& reports_;
  QString path_;
  QString imported_;     // the path where it was imported and not opened since
  QStringList unsaved_;  // where the GCM's answer is waited for before it is written
  SystemFile file_;
  SystemComparison comparison_;
  std::int64_t modified_ = 0;  // ns since 1970; 0 while it is as the file says
  Snapshots snapshots_;
  std::optional<std::map<std::string, SystemFile::Position>> layout_;
  QTimer soon_;
  bool is_comparing_ = false;
  bool is_behind_ = false;     // compare once more
  std::uint64_t version_ = 0;  // of file_
  std::shared_ptr<Courier> courier_;
  Background thread_{QT_TRANSLATE_NOOP("Words", "a system file")};
  Background comparing_{QT_TRANSLATE_NOOP("Words", "the comparison with a system file")};
};

}  // namespace tendon::gui
