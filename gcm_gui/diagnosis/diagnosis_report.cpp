#include <gcm_gui/diagnosis/diagnosis_report.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>

#include <algorithm>

namespace tendon::gui {
namespace {

QString Name(const InterfaceName& name) { return ToQString(ToString(name)); }

QString VerdictWord(DiagnosisStep::Verdict verdict) {
  switch (verdict) {
    case DiagnosisStep::Verdict::kGood:
      return QStringLiteral("ok  ");
    case DiagnosisStep::Verdict::kBad:
      return QStringLiteral("BAD ");
    case DiagnosisStep::Verdict::kNotReached:
      break;
  }
  return QStringLiteral("-   ");
}

}  // namespace

QString DiagnosisReport::verdict() const {
  const auto& steps = diagnosis.steps;
  const auto bad = std::ranges::find(steps, DiagnosisStep::Verdict::kBad, &DiagnosisStep::verdict);
  if (bad != steps.end()) {
    return Words::tr("fails at step %1 of %2").arg(bad - steps.begin() + 1).arg(steps.size());
  }
  return diagnosis.is_connected ? Words::tr("connected and working")
                                : Words::tr("nothing prevents the connection");
}

QString DiagnosisReport::history() const {
  if (!refusal) return {};
  const QString time = ClockText(refusal->when).section('.', 0, 0);
  return Words::tr("refused at %1: %2").arg(time, refusal->reason);
}

QString DiagnosisReport::command() const {
  return QStringLiteral("gcm explain %1 %2")
      .arg(Name(diagnosis.ends.required), Name(diagnosis.ends.provided));
}

QString DiagnosisReport::text() const {
  const message::ConnectionEnds& ends = diagnosis.ends;
  QStringList lines{Name(ends.required) + QStringLiteral(" -> ") + Name(ends.provided) +
                    QStringLiteral(": ") + verdict()};
  if (refusal) lines.append(QStringLiteral("  ") + history());
  int number = 0;
  for (const DiagnosisStep& step : diagnosis.steps) {
    lines.append(QStringLiteral("  %1 ").arg(++number) + VerdictWord(step.verdict) +
                 ToQString(step.text));
    for (const auto& detail : step.details) {
      lines.append(QStringLiteral("         ") + ToQString(detail));
    }
    if (!step.fix.empty()) {
      lines.append(Words::tr("         fix: ") + ToQString(step.fix));
    }
  }
  for (const QString& line : leftovers) lines.append(QStringLiteral("  ") + line);
  lines.append(Words::tr("  the same in a terminal: ") + command());
  return lines.join('\n') + '\n';
}

std::optional<InterfaceName> LikelyProvider(const Catalogue& catalogue,
                                            const RefusedConnections& refusals,
                                            const InterfaceName& required) {
  if (const auto* refused = refusals.find(required)) return refused->provided;
  if (const auto* connection = catalogue.FindConnection(required)) return connection->provided;
  const auto candidates = RankCandidates(catalogue, required);
  if (!candidates || candidates->empty()) return std::nullopt;
  return candidates->front().provided;
}

QString CommandOfFix(const std::string& fix) {
  const auto begin = fix.find("gcm ");
  return ToQString(begin == std::string::npos ? fix : fix.substr(begin));
}

}  // namespace tendon::gui
