#pragma once

#include <gcm_gui/session/gcm_session.h>
#include <gcm_gui/window/main_window.h>
#include <gtest/gtest.h>

#include <QTest>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include "support/folder.h"
#include "support/program.h"

namespace tendon::gui {

inline constexpr int kFlowTimeout = 120'000;  // ms; bounds a test that fails

/// The demo system in separate processes, and the real window with its session in this process.
class FlowFixture : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// Starts a GCM; replaces the former one.
  void StartGcm();
  void OpenWindow();
  [[nodiscard]] bool IsDemoRunning() const;
  [[nodiscard]] bool Eventually(const std::function<bool()>& holds) {
    return QTest::qWaitFor(holds, kFlowTimeout);
  }
  template <typename T>
  T& Find(const char* name) {
    T* found = window_->findChild<T*>(QString::fromLatin1(name));
    if (found == nullptr) throw std::runtime_error(std::string("there is no ") + name);
    return *found;
  }
  /// Clicks a tab with the mouse.
  void ClickTab(const char* bar, const char* title);
  /// Moves the arm always to the same position, so that each move ends soon, with an event.
  void MoveArm();
  void Click(QWidget& widget);

  /// Returns the environment of all programs of the test: they share one cookie.
  [[nodiscard]] std::map<std::string, std::string> FlowEnvironment() const;
  std::unique_ptr<Program> StartLcm(const std::string& name,
                                    const std::string& system = TENDON_DEMO_SYSTEM) const;
  /// Starts `gcm WORDS...` as another program on this machine.
  std::unique_ptr<Program> StartGcmVerb(const Program::Words& words) const;

  const std::string address_ = "127.0.0.1:" + std::to_string(FreePort());
  const test::Folder home_;
  std::unique_ptr<Program> gcm_;
  std::unique_ptr<Program> robot_;
  std::unique_ptr<Program> desk_;
  std::unique_ptr<GcmSession> session_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace tendon::gui
