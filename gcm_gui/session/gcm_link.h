#pragma once

#include <QObject>
#include <QString>
#include <cstdint>

namespace tendon::gui {

/// How the window stands to its GCM. GUI thread.
class GcmLink : public QObject {
  Q_OBJECT

 public:
  enum class State {
    kSearching,  ///< none has been found yet
    kConnected,
    kLost,  ///< there was one
  };

  using QObject::QObject;

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] const QString& address() const { return address_; }
  /// This program hosts the GCM itself.
  [[nodiscard]] bool isHosted() const { return hosted_; }
  /// Why it cannot be reached.
  [[nodiscard]] const QString& reason() const { return reason_; }
  /// When it came into its state, ns since 1970.
  [[nodiscard]] std::int64_t since() const { return since_; }

  void setAddress(const QString& address, bool hosted);
  void setConnected();
  /// Lost, or still searching when there never was one.
  void setUnreachable(const QString& reason);
  /// All that is known of the system is wanted anew.
  void askAnew() { Q_EMIT wantedAnew(); }

 Q_SIGNALS:
  void changed();
  void wantedAnew();

 private:
  void enter(State state);

  State state_ = State::kSearching;
  QString address_;
  bool hosted_ = false;
  QString reason_;
  std::int64_t since_ = 0;
};

}  // namespace tendon::gui
