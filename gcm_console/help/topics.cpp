#include <gcm_console/help/help_text.h>

namespace console {

const std::vector<Topic>& Topics() {
  static const std::vector<Topic> kTopics = {
      {"exit-codes",
       "the exit codes of gcm",
       {{"0", "done"},
        {"1", "refused or failed; the message says why; connect: the connection is not made yet"},
        {"2", "the command line is invalid"},
        {"3", "no GCM answers at the address"},
        {"4", "no such name, or several that match; connect: the GCM has never known the process"},
        {"5", "the two interfaces do not fit; plan: this is the only obstacle"},
        {"6", "no answer in time; the outcome is unknown"},
        {"7", "denied: the role does not suffice, or a file is not safe"},
        {"8", "only some of several things were done"},
        {"130", "interrupted"}}},
      {"paths",
       "how things are named",
       {{"process/component/interface.member, or only the first parts of it"},
        {"robot", "a process"},
        {"robot/arm", "a component"},
        {"robot/arm/Control", "an interface, provided or required"},
        {"robot/arm/Control.MoveTo", "a member: a command, event, function or event handler"},
        {"robot/arm/state.Joints", "a column of the component's state table"},
        {"robot/arm/state.Joints.position[0]", "a part of its value"},
        {"In patterns, * stands for any letters except / and ., and ** for any letters."},
        {"Verbs that take one name do not take a pattern; gcm find lists the names that a pattern "
         "matches."},
        {"In gcm shell, paths are relative to the path of cd; /robot/arm begins at the top, .. "
         "goes one level up."}}},
      {"prompt",
       "the commands of gcm shell besides the verbs",
       {{"cd PATH", "make paths relative to PATH; to the top without a path"},
        {"..", "go one level up"},
        {"VERB &", "run a watch, events, hz or log --follow in the background"},
        {"jobs, end NUMBER", "list the background jobs; end one of them, or all without a number"},
        {"exit", "end the shell and all background jobs"},
        {"VERB; VERB", "one after the other"},
        {"# WORDS", "a remark"},
        {"A gcm before the verb, as in a copied line, is ignored."}}},
      {"output",
       "the format of the output, and where it goes",
       {{"Results go to the standard output, remarks and errors to the standard error."},
        {"terminal", "tables with titles; --no-header leaves the titles out"},
        {"pipe or file", "one line for each row, cells separated by tabs, no titles"},
        {"--json",
         "one document with \"schema\": 1; one line for each row, event, log record or gap"},
        {"-q, -v", "no remarks; or more of them"},
        {"--color WHEN", "auto: on a terminal, unless NO_COLOR is set or TERM is dumb"}}}};
  return kTopics;
}

}  // namespace console
