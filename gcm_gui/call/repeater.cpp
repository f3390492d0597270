#include <gcm_gui/call/repeater.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/models/text.h>

#include <QPointer>
#include <algorithm>

namespace tendon::gui {

Repeater::Repeater(CommandCalls& calls, QObject* parent) : QObject(parent), calls_(calls) {
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, Guarded(this, &Repeater::callNext));
}

void Repeater::start(const QString& path, const std::string& argument, double rate, int times) {
  path_ = path;
  argument_ = argument;
  times_ = times;
  called_ = 0;
  left_out_ = 0;
  ++run_;
  timer_.start(std::max(1, static_cast<int>(1000 / rate)));
  callNext();
}

void Repeater::stop() {
  if (isRunning()) end({});
}

void Repeater::end(const QString& refusal) {
  timer_.stop();
  ++run_;
  Q_EMIT stopped(refusal);
}

void Repeater::callNext() {
  if (under_way_) {
    ++left_out_;
    return Q_EMIT progressed();
  }
  under_way_ = true;
  ++called_;
  const std::uint64_t run = run_;
  calls_.callCommand(path_.toStdString(), argument_,
                     [self = QPointer(this), run](const auto& result, double) {
                       if (self == nullptr) return;
                       self->under_way_ = false;
                       if (self->run_ == run) self->onResult(result);
                     });
  Q_EMIT progressed();
}

void Repeater::onResult(const Result<std::string>& result) {
  if (!result) return end(ToQString(result.error().message));
  if (times_ > 0 && called_ >= times_) end({});
}

}  // namespace tendon::gui
