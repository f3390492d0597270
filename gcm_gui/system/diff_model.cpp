#include <gcm_gui/system/diff_model.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/state_mark.h>

#include <algorithm>
#include <utility>

namespace tendon::gui {
namespace {

struct DifferenceWords {
  const char* sign;
  const char* word;
};

DifferenceWords WordsOf(SystemDifference::Kind kind) {
  switch (kind) {
    case SystemDifference::Kind::kMissing:
      return {"−", QT_TRANSLATE_NOOP("Words", "missing")};
    case SystemDifference::Kind::kExtra:
      return {"+", QT_TRANSLATE_NOOP("Words", "only running")};
    case SystemDifference::Kind::kChanged:
      return {"~", QT_TRANSLATE_NOOP("Words", "changed")};
  }
  return {"?", ""};
}

StateMark LineMark(PlanLine::Kind kind) {
  switch (kind) {
    case PlanLine::Kind::kObstacle:
    case PlanLine::Kind::kNote:
      return StateMark::kWarning;
    case PlanLine::Kind::kWaiting:
      return StateMark::kConstructed;
    case PlanLine::Kind::kDone:
      return StateMark::kActive;
    case PlanLine::Kind::kFailed:
      return StateMark::kFaulted;
    case PlanLine::Kind::kLeft:
      return StateMark::kSuspended;
  }
  return StateMark::kConstructed;
}

PlanLine LineOf(const PlanStep& step, const StepOutcome* outcome) {
  PlanLine line{PlanLine::Kind::kWaiting, ToQString(ToString(step)), {}};
  if (outcome == nullptr) {
    if (step.takes_away) line.trail = Words::tr("stops or removes something that works");
    return line;
  }
  const QString reason =
      outcome->reason.empty() ? QString() : QStringLiteral(": ") + ToQString(outcome->reason);
  switch (outcome->state) {
    case StepOutcome::State::kDone:
      line.kind = PlanLine::Kind::kDone;
      line.trail = Words::tr("done");
      break;
    case StepOutcome::State::kFailed:
      line.kind = PlanLine::Kind::kFailed;
      line.trail = Words::tr("failed");
      line.text += reason;
      break;
    case StepOutcome::State::kLeft:
      line.kind = PlanLine::Kind::kLeft;
      line.trail = Words::tr("left");
      line.text += reason;
      break;
  }
  return line;
}

}  // namespace

QVariant DiffModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const SystemDifference& difference = row(index.row());
  const auto [sign, word] = WordsOf(difference.kind);
  const QString what = ToQString(difference.what);
  switch (role) {
    case Qt::DisplayRole:
      return what;
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
      return QStringLiteral("%1: %2 %3")
          .arg(what, Words::tr(word), ToQString(difference.how))
          .trimmed();
    case kGlyphRole:
      return QString::fromUtf8(sign);
    case kDetailRole:
      return ToQString(difference.how);
    case kTrailRole:
      return Words::tr(word);
    case kPathRole:
      return what.section(' ', 1);
    default:
      return {};
  }
}

QString SummaryOf(const SystemComparison& comparison) {
  const auto count = [&comparison](SystemDifference::Kind kind) {
    return std::count_if(comparison.differences.begin(), comparison.differences.end(),
                         [kind](const auto& one) { return one.kind == kind; });
  };
  return Words::tr("= %1   + %2 only running   − %3 missing   ~ %4 changed")
      .arg(comparison.equal)
      .arg(count(SystemDifference::Kind::kExtra))
      .arg(count(SystemDifference::Kind::kMissing))
      .arg(count(SystemDifference::Kind::kChanged));
}

QVariant PlanModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const PlanLine& line = row(index.row());
  switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
      return line.text;
    case Qt::AccessibleTextRole:
      return line.trail.isEmpty() ? line.text : line.text + QStringLiteral(", ") + line.trail;
    case kGlyphMarkRole:
      return QVariant::fromValue(LineMark(line.kind));
    case kTrailRole:
      return line.trail;
    default:
      return {};
  }
}

void PlanModel::show(const PlanController& restore) {
  std::vector<PlanLine> lines;
  for (const std::string& obstacle : restore.plan().obstacles) {
    lines.push_back({PlanLine::Kind::kObstacle, ToQString(obstacle), Words::tr("not possible")});
  }
  for (const std::string& note : restore.plan().notes) {
    lines.push_back({PlanLine::Kind::kNote, ToQString(note), {}});
  }
  const auto& outcomes = restore.outcomes();
  const auto& steps = restore.plan().steps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    lines.push_back(LineOf(steps[i], i < outcomes.size() ? &outcomes[i] : nullptr));
  }
  showRows(std::move(lines));
}

}  // namespace tendon::gui
