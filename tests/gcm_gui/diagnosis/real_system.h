#pragma once

#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/session/gcm_session.h>
#include <gcm_gui/window/main_window.h>
#include <gtest/gtest.h>

#include <QString>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "support/folder.h"
#include "support/program.h"

namespace tendon::gui {

/// The real window with a real GCM and real `lcm` processes of the demo system, which the test
/// starts, stops and kills.
class RealSystem : public ::testing::Test {
 protected:
  RealSystem();
  ~RealSystem() override;

  /// Starts an LCM, and waits until the catalogue has all of its components.
  void StartLcm(const std::string& process);
  [[nodiscard]] Program& lcm(const std::string& process) { return *lcms_.at(process); }
  /// Runs `gcm WORDS...` without any option, as a new user types it.
  [[nodiscard]] Outcome Gcm(Program::Words words) const;

  [[nodiscard]] MainWindow& window() { return *window_; }
  [[nodiscard]] const Catalogue& Known() { return session_->store().catalogue(); }
  [[nodiscard]] bool IsConnected(const InterfaceName& required);
  [[nodiscard]] ProcessState StateOf(const std::string& process);

  /// Waits until the condition holds, as long as a busy machine may need.
  [[nodiscard]] static bool Eventually(const std::function<bool()>& holds);
  void ClickPort(const PortName& port);
  void ClickEdge(const QString& required);
  void ClickRow(const QString& list, const QString& text);

 private:
  const test::Folder home_;
  const std::string address_ = "127.0.0.1:" + std::to_string(FreePort());
  std::unique_ptr<Program> gcm_;
  std::map<std::string, std::unique_ptr<Program>> lcms_;
  std::unique_ptr<GcmSession> session_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace tendon::gui
