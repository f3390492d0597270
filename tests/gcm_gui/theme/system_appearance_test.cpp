#include <gcm_gui/theme/system_appearance.h>
#include <gmock/gmock.h>

#include <QDBusVariant>
#include <QGuiApplication>
#include <QPalette>
#include <QSignalSpy>

namespace tendon::gui {
namespace {

constexpr auto kGroup = "org.freedesktop.appearance";
constexpr auto kKey = "color-scheme";

// Sends the signal of the desktop portal when the user switches the appearance.
void Say(SystemAppearance& appearance, const QString& key, const QVariant& value) {
  QMetaObject::invokeMethod(&appearance, "onSettingChanged", Q_ARG(QString, kGroup),
                            Q_ARG(QString, key), Q_ARG(QDBusVariant, QDBusVariant(value)));
}

TEST(SystemAppearance, StartsWithTheApplicationPalette) {
  QPalette palette;
  palette.setColor(QPalette::Window, Qt::black);
  QGuiApplication::setPalette(palette);
  EXPECT_EQ(SystemAppearance().appearance(), Appearance::kDark);

  palette.setColor(QPalette::Window, Qt::white);
  QGuiApplication::setPalette(palette);
  EXPECT_EQ(SystemAppearance().appearance(), Appearance::kLight);
}

TEST(SystemAppearance, FollowsTheDesktop) {
  SystemAppearance appearance;
  QSignalSpy changed(&appearance, &SystemAppearance::changed);

  Say(appearance, kKey, 2U);
  Say(appearance, kKey, 1U);
  EXPECT_EQ(appearance.appearance(), Appearance::kDark);
  Say(appearance, kKey, 2U);

  EXPECT_EQ(appearance.appearance(), Appearance::kLight);
  EXPECT_GE(changed.count(), 2);
}

TEST(SystemAppearance, AcceptsADoublyWrappedPortalValue) {
  SystemAppearance appearance;
  Say(appearance, kKey, 2U);

  Say(appearance, kKey, QVariant::fromValue(QDBusVariant(1U)));

  EXPECT_EQ(appearance.appearance(), Appearance::kDark);
}

TEST(SystemAppearance, NoPreferenceAndOtherSettingsChangeNothing) {
  SystemAppearance appearance;
  Say(appearance, kKey, 1U);
  QSignalSpy changed(&appearance, &SystemAppearance::changed);

  Say(appearance, kKey, 0U);
  Say(appearance, "accent-color", 2U);

  EXPECT_EQ(changed.count(), 0);
  EXPECT_EQ(appearance.appearance(), Appearance::kDark);
}

}  // namespace
}  // namespace tendon::gui
