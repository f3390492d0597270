#pragma once

#include <gcm_gui/session/courier.h>
#include <gcm_gui/system/plan_runner.h>
#include <tendon/gcm/client.h>

#include <QObject>
#include <QThreadPool>
#include <chrono>
#include <memory>
#include <mutex>

namespace tendon::gui {

/// Makes the steps of plans in a thread of its own, by asking a GCM for them.
class PlanWorker final : public QObject, public PlanRunner {
  Q_OBJECT

 public:
  /// So long `client`, which outlives the worker, waits for an answer.
  PlanWorker(GcmClient& client, std::chrono::milliseconds timeout);
  /// Waits for the step that is being made.
  ~PlanWorker() override;

  void carryOut(Plan plan, AfterError after_error, Progress progress, Done done) override;
  void stop() override { setStopped(true); }

 private:
  void setStopped(bool stopped);
  [[nodiscard]] bool isStopped();

  GcmClient& client_;
  const std::chrono::milliseconds timeout_;
  std::shared_ptr<Courier> courier_;
  std::mutex mutex_;
  bool is_stopped_ = false;  // guarded by mutex_
  QThreadPool thread_;
};

}  // namespace tendon::gui
