#pragma once

#include <gcm_gui/files/background.h>
#include <gcm_gui/files/gui_poster.h>
#include <gcm_gui/system/plan_runner.h>
#include <tendon/gcm/client.h>
#include <tendon/lockfree/flag.h>

#include <QObject>
#include <chrono>
#include <memory>

namespace tendon::gui {

/// Executes the steps of plans in its own thread, by requests to a GCM.
class PlanWorker final : public QObject, public PlanRunner {
  Q_OBJECT

 public:
  /// `timeout` is the time that `client` waits for a reply.
  PlanWorker(std::shared_ptr<GcmClient> client, std::chrono::milliseconds timeout);
  /// Waits for a limited time until the present step is finished.
  ~PlanWorker() override;

  void carryOut(Plan plan, AfterError after_error, Progress progress, Done done) override;
  void stop() override;

 private:
  std::shared_ptr<GcmClient> client_;
  const std::chrono::milliseconds timeout_;
  std::shared_ptr<GuiPoster> poster_;
  std::shared_ptr<Flag> is_stopped_;  // set to stop the newest plan after its present step
  Background thread_{QT_TRANSLATE_NOOP("Words", "a step of a plan")};
};

}  // namespace tendon::gui
