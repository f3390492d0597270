#include <gcm_console/verbs/verb.h>

#include <utility>

namespace console {
namespace {

struct Group {
  const char* name;
  std::vector<Verb> (*verbs)();
};

/// All verbs, in the order in which `gcm help` lists them.
constexpr Group kGroups[] = {
    {"look", &FindVerbs},        //
    {"look", &LookVerbs},        //
    {"look", &ShowVerbs},        //
    {"look", &TopVerbs},         //
    {"data", &DataVerbs},        //
    {"data", &EventVerbs},       //
    {"data", &RateVerbs},        //
    {"data", &PlotVerbs},        //
    {"data", &LogVerbs},         //
    {"act", &ActVerbs},          //
    {"act", &ClassVerbs},        //
    {"act", &SetVerbs},          //
    {"act", &LifecycleVerbs},    //
    {"wire", &ConnectionVerbs},  //
    {"wire", &ExplainVerbs},     //
    {"config", &SystemVerbs},    //
    {"config", &HistoryVerbs},   //
    {"record", &RecordVerbs},    //
    {"record", &PastVerbs},      //
    {"record", &FileVerbs},      //
    {"record", &ReplayVerbs},    //
    {"security", &CertVerbs},    //
    {"meta", &ServeVerbs},       //
    {"meta", &DoctorVerbs},      //
    {"meta", &ShellVerbs},       //
    {"meta", &MetaVerbs},        //
};

}  // namespace

std::vector<Verb> AllVerbs() {
  std::vector<Verb> all;
  for (const Group& group : kGroups) {
    for (Verb& verb : group.verbs()) {
      verb.group = group.name;
      all.push_back(std::move(verb));
    }
  }
  return all;
}

}  // namespace console
