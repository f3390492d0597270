#include <gcm_gui/inspector/thread_facts.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>

#include <QRegularExpression>
#include <QStringList>

namespace tendon::gui {
namespace {

const QString kNone = QStringLiteral("–");

/// Formats a duration without zeros at the end: "1 ms", not "1.000 ms".
QString ShortDuration(double seconds) {
  static const QRegularExpression zeros(QStringLiteral("\\.?0+(?= )"));
  const QString text = DurationText(seconds);
  return text.contains('.') ? QString(text).remove(zeros) : text;
}

QString OwnerText(const ComponentDescription& component) {
  if (!component.leader.empty()) {
    return Words::tr("the thread of %1").arg(ToQString(component.leader));
  }
  return component.thread.empty() ? Words::tr("none of its own") : Words::tr("its own");
}

QString SchedulingText(const ThreadOptions& options) {
  switch (options.policy) {
    case SchedulingPolicy::kFifo:
      return QStringLiteral("FIFO %1").arg(options.priority);
    case SchedulingPolicy::kRoundRobin:
      return QStringLiteral("RR %1").arg(options.priority);
    case SchedulingPolicy::kNormal:
      break;
  }
  return Words::tr("normal");
}

QString ProcessorsText(const ThreadOptions& options) {
  if (options.cpus.empty()) return Words::tr("any");
  QStringList numbers;
  for (const std::int32_t cpu : options.cpus) numbers.append(QString::number(cpu));
  return numbers.join(QStringLiteral(", "));
}

QList<Property> CycleFacts(double period, const CycleFigures& figures) {
  const auto& last = figures.lastSecond();
  const auto time = [&](double CycleFigures::LastSecond::*value) {
    return last ? DurationText((*last).*value) : kNone;
  };
  using Second = CycleFigures::LastSecond;
  return {
      {Words::tr("Wanted period"),
       ShortDuration(period) + QStringLiteral(" · ") + RateOfPeriodText(period)},
      {Words::tr("Period"), time(&Second::period), Words::tr("Mean of the last second")},
      {Words::tr("Longest period"), time(&Second::longest)},
      {Words::tr("Starts late by"), time(&Second::late),
       Words::tr("Median of the last second: half of the cycles start at most this late")},
      {Words::tr("99 of 100 start within"), time(&Second::later)},
      {Words::tr("Latest start"), time(&Second::latest)},
      {Words::tr("Computes for"), time(&Second::compute), Words::tr("Mean of the last second")},
      {Words::tr("Longest computation"), time(&Second::most_computed)},
      {Words::tr("Skipped cycles"), figures.skipped() ? QString::number(*figures.skipped()) : kNone,
       Words::tr(
           "Since the task was started; a cycle is skipped if an earlier one took too long")}};
}

}  // namespace

QList<Property> TimingFacts(double period, const CycleFigures& figures) {
  const auto& last = figures.lastSecond();
  const QString percent = last ? QString::number(100 * last->compute / period, 'f', 1) : kNone;
  return {
      {Words::tr("Period"),
       ShortDuration(period) +
           (last ? Words::tr(" · now ") + DurationText(last->period) : QString()),
       Words::tr("Planned rate, and actual rate in the last second")},
      {Words::tr("Starts late by"),
       last ? Words::tr("%1 · max %2").arg(DurationText(last->late), DurationText(last->latest))
            : kNone,
       last ? Words::tr("Delay of the cycles of the last second: at most %1 for half of them, %2 "
                        "for 99 of 100, %3 for all")
                  .arg(DurationText(last->late), DurationText(last->later),
                       DurationText(last->latest))
            : QString()},
      {Words::tr("Skipped cycles"), figures.skipped() ? QString::number(*figures.skipped()) : kNone,
       Words::tr("Since the task was started; a cycle is skipped if an earlier one took too long")},
      {Words::tr("Busy"),
       last ? QStringLiteral("%1 % · %2").arg(percent, DurationText(last->compute)) : kNone,
       Words::tr("Share of the period that is used for computation, mean of the last second")}};
}

QList<Property> ThreadFacts(const ComponentDescription& component, const CycleFigures& figures) {
  QList<Property> facts{{Words::tr("Thread"), OwnerText(component)}};
  if (!component.thread.empty() && component.leader.empty()) {
    const ThreadOptions& options = component.thread.front();
    facts.append({Words::tr("Scheduling"), SchedulingText(options)});
    facts.append({Words::tr("Processors"), ProcessorsText(options)});
  }
  if (component.period > 0) facts += CycleFacts(component.period, figures);
  if (!component.warning.empty()) {
    facts.append(
        {Words::tr("Warning"), ToQString(component.warning), {}, Property::Kind::kSentence});
  }
  return facts;
}

}  // namespace tendon::gui
