#include <gcm_gui/theme/system_appearance.h>

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QDBusVariant>
#include <QGuiApplication>
#include <QPalette>

namespace tendon::gui {
namespace {

constexpr auto kService = "org.freedesktop.portal.Desktop";
constexpr auto kObject = "/org/freedesktop/portal/desktop";
constexpr auto kInterface = "org.freedesktop.portal.Settings";
constexpr auto kGroup = "org.freedesktop.appearance";
constexpr auto kKey = "color-scheme";
constexpr uint kPreferDark = 1;
constexpr uint kPreferLight = 2;

// Removes the variants around a reply. An older portal puts the reply into two variants.
QVariant Unwrapped(QVariant value) {
  while (value.canConvert<QDBusVariant>()) value = value.value<QDBusVariant>().variant();
  return value;
}

Appearance OfPalette() {
  const QColor window = QGuiApplication::palette().color(QPalette::Window);
  return window.lightnessF() < 0.5F ? Appearance::kDark : Appearance::kLight;
}

}  // namespace

SystemAppearance::SystemAppearance(QObject* parent) : QObject(parent), appearance_(OfPalette()) {
  // Does not ask if the address of the bus is not set: Qt would then start a bus, which may take
  // long.
  if (!qEnvironmentVariableIsEmpty("DBUS_SESSION_BUS_ADDRESS")) askPortal();
}

void SystemAppearance::askPortal() {
  QDBusConnection bus = QDBusConnection::sessionBus();
  if (!bus.isConnected()) return;
  bus.connect(kService, kObject, kInterface, "SettingChanged", this,
              SLOT(onSettingChanged(QString, QString, QDBusVariant)));
  QDBusMessage call = QDBusMessage::createMethodCall(kService, kObject, kInterface, "Read");
  call << QString(kGroup) << QString(kKey);
  auto* watcher = new QDBusPendingCallWatcher(bus.asyncCall(call), this);
  connect(watcher, &QDBusPendingCallWatcher::finished, this, [this, watcher] {
    const QDBusPendingReply<QDBusVariant> reply = *watcher;
    if (!reply.isError()) onSettingChanged(kGroup, kKey, reply.value());
    watcher->deleteLater();
  });
}

void SystemAppearance::onSettingChanged(const QString& group, const QString& key,
                                        const QDBusVariant& value) {
  if (group != kGroup || key != kKey) return;
  const uint preference = Unwrapped(value.variant()).toUInt();
  if (preference == kPreferDark) set(Appearance::kDark);
  if (preference == kPreferLight) set(Appearance::kLight);
}

void SystemAppearance::set(Appearance appearance) {
  if (appearance == appearance_) return;
  appearance_ = appearance;
  Q_EMIT changed();
}

}  // namespace tendon::gui
