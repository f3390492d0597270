#pragma once

#include <gcm_gui/theme/tokens.h>

#include <QObject>

class QDBusVariant;

namespace tendon::gui {

/// Whether the desktop asks for dark or light windows.
///
/// Asks the desktop portal without waiting for it; until it has answered, and where there is none,
/// the palette with which the application started decides.
class SystemAppearance : public QObject {
  Q_OBJECT

 public:
  explicit SystemAppearance(QObject* parent = nullptr);

  [[nodiscard]] Appearance appearance() const { return appearance_; }

 Q_SIGNALS:
  void changed();

 private:
  Q_SLOT void hearSetting(const QString& group, const QString& key, const QDBusVariant& value);

  void askPortal();
  void set(Appearance appearance);

  Appearance appearance_;
};

}  // namespace tendon::gui
