#pragma once

#include <gcm_gui/session/session.h>
#include <gcm_gui/window/main_window.h>

#include <QString>
#include <memory>

#include "gcm_console/system_fixture.h"

namespace tendon::gui {

inline constexpr int kLivePatience = 60000;  // ms; bounds a test that fails

/// A real window beside a GCM and LCMs that are processes of their own.
class LiveWindow : public SystemFixture {
 protected:
  ~LiveWindow() override;

  /// A window that is shown, and knows `path`.
  void Open(const QString& path);
  MainWindow& window() { return *window_; }
  Session& session() { return *session_; }
  [[nodiscard]] bool Knows(const QString& path) const;
  /// Selects a row of the catalogue as a user does: with the mouse.
  void Click(const QString& path, Qt::KeyboardModifiers modifiers = {});
  /// Dark and light, at 1x and 2x, as artefacts.
  void KeepPictures(const QString& name);

 private:
  std::unique_ptr<Session> session_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace tendon::gui
