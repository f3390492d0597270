#include <gcm_gui/activity/problems_model.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/connection_index.h>
#include <gcm_gui/models/plugin_words.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/models/text.h>

#include <algorithm>
#include <utility>

namespace tendon::gui {
namespace {

QString WithReason(const QString& text, const std::string& reason) {
  return reason.empty() ? text : text + QStringLiteral(": ") + ToQString(reason);
}

void AddProblemsOf(const ProcessEntry& entry, const ConnectionIndex& connections,
                   std::vector<ListedProblem>& problems) {
  const ProcessDescription& process = entry.process;
  const QString name = ToQString(process.name);
  if (process.state == ProcessState::kLost) {
    problems.push_back({name, WithReason(name + Words::tr(" is lost"), process.reason),
                        StateMark::kLost, process.since});
    return;  // all other problems of the process follow from this one
  }
  if (process.state == ProcessState::kSuspect) {
    problems.push_back({name, name + Words::tr(" does not answer; its values may be old"),
                        StateMark::kWarning, process.since});
  }
  const bool is_hidden = process.state == ProcessState::kAlive && !process.reason.empty();
  if (is_hidden) {
    problems.push_back(
        {name, WithReason(name, process.reason), StateMark::kWarning, process.since});
  }
  for (const PluginDescription& plugin : process.plugins) {
    if (plugin.state == PluginState::kCurrent || IsGone(process.state)) continue;
    problems.push_back(
        {name, OldPluginWords(name, plugin), StateMark::kWarning, plugin.written_now});
  }
  for (const auto& [component_name, component] : entry.components) {
    const QString path = name + '/' + ToQString(component_name);
    if (component.state == ComponentState::kFaulted) {
      problems.push_back({path, WithReason(path + Words::tr(" is faulted"), component.fault),
                          StateMark::kFaulted, component.fault_time});
    }
    auto waits = WaitsOf(connections, entry, component);
    const auto& waiting = component.name;
    std::erase_if(waits, [&](const UnsatisfiedInterface& need) {  // these are failed connections
      const auto* connection = connections.Of({process.name, waiting, need.interface});
      return connection != nullptr && connection->state == ConnectionState::kFailed;
    });
    if (waits.empty()) continue;
    problems.push_back(
        {path, path + Words::tr(" waits for ") + ReasonsText(waits), StateMark::kWarning, 0});
  }
  for (const auto& [id, connection] : entry.connections) {
    if (connection.state != ConnectionState::kFailed) continue;
    const QString path = ToQString(ToString(connection.required));
    problems.push_back({path, WithReason(path + Words::tr(" is not connected"), connection.reason),
                        StateMark::kRefused, 0});
  }
}

}  // namespace

QVariant ProblemsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const ListedProblem& problem = row(index.row());
  switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
      return problem.text;
    case kTimeRole:
      return problem.time;
    case kGlyphMarkRole:
      return QVariant::fromValue(problem.mark);
    case kPathRole:
      return problem.path;
    default:
      return {};
  }
}

void ProblemsModel::update(const Catalogue& catalogue) {
  of_system_.clear();
  const ConnectionIndex connections(catalogue);
  for (const auto& [name, entry] : catalogue.processes()) {
    AddProblemsOf(entry, connections, of_system_);
  }
  dropRecovered(catalogue);
  show();
}

void ProblemsModel::dropRecovered(const Catalogue& catalogue) {
  for (auto it = refusals_.begin(); it != refusals_.end();) {
    const auto* connection = catalogue.FindConnection(it->first);
    const bool connected = connection != nullptr && connection->state == ConnectionState::kActive;
    it = connected || catalogue.FindRequired(it->first) == nullptr ? refusals_.erase(it)
                                                                   : std::next(it);
  }
}

void ProblemsModel::onActionFinished(const Action& finished) {
  if (finished.verb != Action::Verb::kConnect && finished.verb != Action::Verb::kReplace) return;
  if (finished.outcome == Action::Outcome::kRefused) {
    refusals_[finished.required] = {ToQString(ToString(finished.required)), finished.refusal,
                                    StateMark::kRefused, finished.when};
  } else {
    refusals_.erase(finished.required);
  }
  show();
}

void ProblemsModel::showFaults(const QList<ViewFault>& faults) {
  if (faults == faults_) return;
  faults_ = faults;
  of_views_.clear();
  for (const ViewFault& fault : faults) {
    const QString begin = fault.is_covered ? Words::tr("%1 is not drawn because of an error: %2")
                                           : Words::tr("%1 had an error: %2");
    QString text = begin.arg(fault.view, fault.what);
    if (fault.count > 1) text += Words::tr(" (%1 times)").arg(fault.count);
    of_views_.push_back({{}, text, StateMark::kFaulted, fault.first});
  }
  show();
}

void ProblemsModel::show() {
  std::vector<ListedProblem> fresh = of_system_;
  fresh.insert(fresh.end(), of_views_.begin(), of_views_.end());
  for (const auto& [required, problem] : refusals_) fresh.push_back(problem);
  std::stable_partition(fresh.begin(), fresh.end(), [](const ListedProblem& problem) {
    return problem.mark != StateMark::kWarning;
  });
  QString blank;
  for (ListedProblem& problem : fresh) {
    if (problem.since == 0) continue;
    problem.time = ClockText(problem.since);
    blank.fill(' ', problem.time.size());
  }
  for (ListedProblem& problem : fresh) {
    if (problem.since == 0) problem.time = blank;
  }
  const int count = rowCount();
  showRows(std::move(fresh));
  if (rowCount() != count) Q_EMIT countChanged(rowCount());
}

}  // namespace tendon::gui
