#include <tendon/gcm/system/comparison.h>

#include <tendon/gcm/system/system_index.h>
#include <tendon/payload/json.h>
#include <tendon/payload/json/strict_json.h>

#include <nlohmann/json.hpp>

namespace tendon {
namespace {

using DifferenceKind = SystemDifference::Kind;

std::string OrNone(const std::string& text) { return text.empty() ? "none" : text; }

std::string SecondsText(double seconds) { return nlohmann::json(seconds).dump() + " s"; }

std::string TextOf(const std::optional<SystemFile::Start>& start) {
  return start ? "by the GCM (restart " + std::string(ToString(start->restart)) + ")" : "by others";
}

std::string TextOf(bool value) { return value ? "true" : "false"; }

/// Appends "NAME FIRST -> SECOND".
void AddChange(std::string& changes, const std::string& name, const std::string& first,
               const std::string& second) {
  if (!changes.empty()) changes += "; ";
  changes += name + " " + first + " -> " + second;
}

class Comparer {
 public:
  Comparer(const SystemFile& first, const SystemFile& second, StartComparison starts)
      : first_(first), second_(second), starts_(starts) {}

  SystemComparison Run() {
    if (starts_ == StartComparison::kCompare && first_.strict != second_.strict) {
      Add(DifferenceKind::kChanged, "strict",
          TextOf(first_.strict) + " -> " + TextOf(second_.strict));
    }
    for (const auto& process : first_.processes) CompareProcess(process);
    for (const auto& process : second_.processes) {
      if (first_index_.FindProcess(process.name) == nullptr)
        AddWhole(DifferenceKind::kExtra, process);
    }
    CompareConnections();
    return std::move(comparison_);
  }

 private:
  void Add(DifferenceKind kind, const std::string& what, const std::string& how = "") {
    comparison_.differences.push_back({kind, what, how});
  }

  void AddWhole(DifferenceKind kind, const SystemFile::Process& process) {
    Add(kind, "process " + process.name);
    for (const auto& component : process.components) {
      Add(kind, "component " + process.name + "/" + component.name);
    }
  }

  void CompareProcess(const SystemFile::Process& process) {
    const auto* other = second_index_.FindProcess(process.name);
    if (other == nullptr) return AddWhole(DifferenceKind::kMissing, process);
    if (starts_ == StartComparison::kCompare && process.start != other->start) {
      Add(DifferenceKind::kChanged, "process " + process.name,
          "start " + TextOf(process.start) + " -> " + TextOf(other->start));
    } else {
      ++comparison_.equal;
    }
    const std::string begin = "component " + process.name + "/";
    for (const auto& component : process.components) {
      const auto* same = second_index_.FindComponent(process.name, component.name);
      if (same == nullptr) {
        Add(DifferenceKind::kMissing, begin + component.name);
        continue;
      }
      const std::string changes = ChangesOf(component, *same);
      if (changes.empty()) {
        ++comparison_.equal;
      } else {
        Add(DifferenceKind::kChanged, begin + component.name, changes);
      }
    }
    for (const auto& component : other->components) {
      const bool is_known = first_index_.FindComponent(process.name, component.name) != nullptr;
      if (!is_known) Add(DifferenceKind::kExtra, begin + component.name);
    }
  }

  void CompareConnections() {
    const auto whole = [](const SystemFile::Connection& connection) {
      return "connection " + ToString(connection.required) + " -> " + ToString(connection.provided);
    };
    for (const auto& connection : first_.connections) {
      const auto* other = second_index_.FindConnection(connection.required);
      if (other == nullptr) {
        Add(DifferenceKind::kMissing, whole(connection));
      } else if (other->provided == connection.provided) {
        ++comparison_.equal;
      } else {
        Add(DifferenceKind::kChanged, "connection " + ToString(connection.required),
            "to " + ToString(connection.provided) + " -> " + ToString(other->provided));
      }
    }
    for (const auto& connection : second_.connections) {
      if (first_index_.FindConnection(connection.required) == nullptr) {
        Add(DifferenceKind::kExtra, whole(connection));
      }
    }
  }

  const SystemFile& first_;
  const SystemFile& second_;
  const StartComparison starts_;
  const SystemIndex first_index_{first_};
  const SystemIndex second_index_{second_};
  SystemComparison comparison_;
};

}  // namespace

SystemComparison CompareSystems(const SystemFile& first, const SystemFile& second,
                                StartComparison starts) {
  return Comparer(first, second, starts).Run();
}

std::string ChangesOf(const SystemFile::Component& first, const SystemFile::Component& second) {
  std::string changes;
  if (first.class_name != second.class_name) {
    AddChange(changes, "class", OrNone(first.class_name), OrNone(second.class_name));
  }
  if (!IsSameLibrary(first, second)) {
    AddChange(changes, "library", OrNone(first.library), OrNone(second.library));
  }
  if (!IsSameJson(first.configuration, second.configuration)) {
    AddChange(changes, "configuration", OrNone(first.configuration), OrNone(second.configuration));
  }
  const bool has_periods = first.period > 0.0 && second.period > 0.0;
  if (has_periods && first.period != second.period) {
    AddChange(changes, "period", SecondsText(first.period), SecondsText(second.period));
  }
  if (first.thread && second.thread && *first.thread != *second.thread) {
    AddChange(changes, "thread", ToJson(*first.thread), ToJson(*second.thread));
  }
  if (!HasSameLeader(first, second)) {
    AddChange(changes, "runs_after", OrNone(first.runs_after), OrNone(second.runs_after));
  }
  if (!SatisfiesSameRequest(first.state, second.state)) {
    AddChange(changes, "state", std::string(ToString(first.state)),
              std::string(ToString(second.state)));
  }
  return changes;
}

bool SatisfiesSameRequest(ComponentState one, ComponentState other) {
  return one == other || (!IsRunning(one) && !IsRunning(other));
}

bool IsSameLibrary(const SystemFile::Component& one, const SystemFile::Component& other) {
  return one.library.empty() || other.library.empty() || one.library == other.library;
}

bool HasSameLeader(const SystemFile::Component& one, const SystemFile::Component& other) {
  return !one.tells_thread() || !other.tells_thread() || one.runs_after == other.runs_after;
}

bool IsSameThread(const SystemFile::Component& one, const SystemFile::Component& other) {
  const bool is_known = one.thread && other.thread;
  return HasSameLeader(one, other) && (!is_known || *one.thread == *other.thread);
}

bool IsSameJson(const std::string& one, const std::string& other) {
  if (one == other) return true;
  const auto parsed = ParseStrictJson(one);  // limits the nesting, because == is recursive
  const auto other_parsed = ParseStrictJson(other);
  return parsed && other_parsed && *parsed == *other_parsed;
}

}  // namespace tendon
