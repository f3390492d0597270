#pragma once

#include <gcm_gui/theme/tokens.h>

#include <QObject>

class QDBusVariant;

namespace tendon::gui {

/// The desktop's preference for dark or light windows.
///
/// Asks the desktop portal without waiting. Until the portal answers, or without one, uses the
/// palette at the start of the application.
class SystemAppearance : public QObject {
  Q_OBJECT

 public:
  explicit SystemAppearance(QObject* parent = nullptr);

  [[nodiscard]] Appearance appearance() const { return appearance_; }

 Q_SIGNALS:
  void changed();

 private:
  Q_SLOT void onSettingChanged(const QString& group, const QString& key, const QDBusVariant& value);

  void askPortal();
  void set(Appearance appearance);

  Appearance appearance_;
};

}  // namespace tendon::gui
