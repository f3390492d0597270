#pragma once

#include <QObject>
#include <QString>
#include <cstdint>

namespace tendon::gui {

/// The state of the window's link to its GCM. GUI thread.
class LinkState : public QObject {
  Q_OBJECT

 public:
  enum class State {
    kSearching,  ///< never found so far
    kConnected,
    kLost,  ///< found before, but unreachable now
  };

  using QObject::QObject;

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] const QString& address() const { return address_; }
  /// True if the system is a recording, and address() the name of its file. Then the link is either
  /// connected or searching. If it is searching, the file is being opened, or reason() says why it
  /// cannot be shown.
  [[nodiscard]] bool isFile() const { return is_file_; }
  /// True if the GCM runs inside this program.
  [[nodiscard]] bool isHosted() const { return hosted_; }
  /// The reason why the GCM is unreachable.
  [[nodiscard]] const QString& reason() const { return reason_; }
  /// The time at which the present state began, in ns since 1970.
  [[nodiscard]] std::int64_t since() const { return since_; }

  void setAddress(const QString& address, bool hosted);
  void setFile(const QString& name);
  void setConnected();
  /// Sets the state kLost. If the GCM was never found, sets the state kSearching.
  void setUnreachable(const QString& reason);
  /// Requests the whole state of the system again.
  void requestResync() { Q_EMIT resyncRequested(); }

 Q_SIGNALS:
  void changed();
  void resyncRequested();

 private:
  void enter(State state);

  State state_ = State::kSearching;
  QString address_;
  bool hosted_ = false;
  bool is_file_ = false;
  QString reason_;
  std::int64_t since_ = 0;
};

}  // namespace tendon::gui
