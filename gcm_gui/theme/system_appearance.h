#pragma once

#include <gcm_gui/theme/tokens.h>

#include <QObject>

class QDBusVariant;

namespace tendon::gui {

/// Knows whether the user of the desktop prefers dark or light windows.
///
/// The desktop portal is asked asynchronously. Until it answers, or if there is no portal, the
/// palette at the start of the application decides.
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
