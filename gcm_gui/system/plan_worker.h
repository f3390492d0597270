#pragma once

#include <gcm_gui/files/background.h>
#include <gcm_gui/session/courier.h>
#include <gcm_gui/system/plan_runner.h>
#include <tendon/gcm/client.h>
#include <tendon/lockfree/flag.h>

#include <QObject>
#include <chrono>
#include <memory>

namespace tendon::gui {

/// Makes the steps of plans in a thread of its own, by asking a GCM for them.
class PlanWorker final : public QObject, public PlanRunner {
  Q_OBJECT

 public:
  /// So long `client` waits for an answer.
  PlanWorker(std::shared_ptr<GcmClient> client, std::chrono::milliseconds timeout);
  /// Waits for the step that is being made, though not for ever.
  ~PlanWorker() override;

  void carryOut(Plan plan, AfterError after_error, Progress progress, Done done) override;
  void stop() override;

 private:
  std::shared_ptr<GcmClient> client_;
  const std::chrono::milliseconds timeout_;
  std::shared_ptr<Courier> courier_;
  std::shared_ptr<Flag> is_stopped_;  // of the newest plan: it is left after the step that is made
  Background thread_{QT_TRANSLATE_NOOP("Words", "a step of a plan")};
};

}  // namespace tendon::gui
