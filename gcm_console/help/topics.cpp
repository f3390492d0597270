#include <gcm_console/help/help_text.h>

namespace console {

const std::vector<Topic>& Topics() {
  static const std::vector<Topic> kTopics = {
      {"exit-codes",
       "how gcm ends",
       {{"0", "done"},
        {"1", "refused or failed; the sentence says why; connect: the connection does not stand"},
        {"2", "the command line makes no sense"},
        {"3", "there is no GCM at the address"},
        {"4", "no such name, or several; connect: nobody has ever seen that process"},
        {"5", "the two ends do not fit; plan: that is all there is in the way"},
        {"6", "no answer in time; the outcome is unknown"},
        {"7", "denied: not with this role, or a file that is not safe"},
        {"8", "of several things, some were done"},
        {"130", "interrupted"}}},
      {"paths",
       "how things are named",
       {{"process/component/interface.member, as far as is needed"},
        {"robot", "a process"},
        {"robot/arm", "a component"},
        {"robot/arm/Control", "an interface, provided or required"},
        {"robot/arm/Control.MoveTo", "a member: a command, event, function or event handler"},
        {"robot/arm/state.Joints", "a column of the component's state table"},
        {"robot/arm/state.Joints.position[0]", "a part of its value"},
        {"In patterns, * stands for any letters but / and . and ** for any letters at all."},
        {"Verbs that take one name take no pattern; gcm find lists what one names."},
        {"In gcm shell, paths begin where cd went; /robot/arm begins at the top, .. goes up."}}},
      {"prompt",
       "what gcm shell knows beside the verbs",
       {{"cd PATH", "let paths begin there; at the top without a path"},
        {"..", "let them begin one step higher"},
        {"VERB &", "leave a watch, events, hz or log --follow behind the prompt"},
        {"jobs, end NUMBER", "list what goes on there; end one of them, or all without a number"},
        {"exit", "end the shell, and all that goes on behind it"},
        {"VERB; VERB", "one after the other"},
        {"# WORDS", "a remark"},
        {"A gcm before the verb, as in a line from elsewhere, is passed over."}}},
      {"output",
       "what is printed, where and how",
       {{"Results go to the standard output, remarks and errors to the standard error."},
        {"terminal", "tables with titles; --no-header leaves the titles out"},
        {"pipe or file", "one line a row, cells separated by tabs, no titles"},
        {"--json", "one document with \"schema\": 1; rows, events, log records, gaps one a line"},
        {"-q, -v", "no remarks; or more of them"},
        {"--color WHEN", "auto: on a terminal, unless NO_COLOR is set or TERM is dumb"}}}};
  return kTopics;
}

}  // namespace console
