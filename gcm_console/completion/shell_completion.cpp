#include <gcm_console/completion/shell_completion.h>

#include <gcm_console/command_line/command_line.h>
#include <gcm_console/completion/completer.h>
#include <gcm_console/completion/live_completion.h>

#include <algorithm>
#include <map>

namespace console {
namespace {

/// The maximum time that the user waits after pressing Tab.
constexpr std::chrono::milliseconds kCompletionTimeout(300);

constexpr const char* kBash = R"(# bash completion of gcm
_gcm() {
  # bash splits words also at ':' and '=', as in HOST:PORT; this joins the parts again.
  local -a words=()
  local i piece rest=$COMP_LINE
  for ((i = 0; i <= COMP_CWORD; ++i)); do
    piece=${COMP_WORDS[i]}
    if [[ $i -gt 0 && $rest != [[:blank:]]* ]]; then
      words[${#words[@]}-1]+=$piece
    else
      words+=("$piece")
    fi
    while [[ $rest == [[:blank:]]* ]]; do rest=${rest:1}; done
    rest=${rest#"$piece"}
  done
  local word="${words[${#words[@]}-1]}" line
  local breaks= begin=  # the beginning of the word, which bash keeps
  [[ $COMP_WORDBREAKS == *:* ]] && breaks+=:
  [[ $COMP_WORDBREAKS == *=* ]] && breaks+==
  [[ -n $breaks ]] && begin=${word%"${word##*[$breaks]}"}
  COMPREPLY=()
  while IFS= read -r line; do
    if [[ $line == :files ]]; then
      compopt -o filenames
      mapfile -t COMPREPLY < <(compgen -f -- "${word#"$begin"}")
      return
    fi
    line=${line%%$'\t'*}
    COMPREPLY+=("${line#"$begin"}")
  done < <(gcm complete "${words[@]:1:${#words[@]}-2}" "$word" 2>/dev/null)
  if [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *[/.=] ]]; then compopt -o nospace; fi
}
complete -F _gcm gcm
)";

constexpr const char* kZsh = R"(#compdef gcm
# zsh completion of gcm
_gcm() {
  local line
  local -a whole begun
  for line in "${(@f)$(gcm complete "${(@)words[2,CURRENT-1]}" "${words[CURRENT]}" 2>/dev/null)}"; do
    if [[ $line == :files ]]; then
      _files
      return
    fi
    line=${line%%$'\t'*}
    if [[ $line == *[/.=] ]]; then begun+=("$line"); elif [[ -n $line ]]; then whole+=("$line"); fi
  done
  compadd -- $whole
  compadd -S '' -- $begun
}
if [[ $funcstack[1] == _gcm ]]; then _gcm "$@"; else compdef _gcm gcm; fi
)";

constexpr const char* kFish = R"(# fish completion of gcm
function __gcm_complete
  set -l words (commandline -opc)
  set -l word (commandline -ct)
  for line in (gcm complete $words[2..-1] "$word" 2>/dev/null)
    if test "$line" = ":files"
      __fish_complete_path "$word"
      return
    end
    echo $line
  end
end
complete -c gcm -f -a '(__gcm_complete)'
)";

/// Returns the value of a global option in `words`: the next word, or the text after '='.
std::string Given(const std::vector<std::string>& words, const std::string& option) {
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {  // the last word is not complete yet
    if (words[i] == option && i + 2 < words.size()) return words[i + 1];
    if (words[i].starts_with(option + "=")) return words[i].substr(option.size() + 1);
  }
  return "";
}

/// Returns a client that has received the catalogue; null if there is no GCM.
std::shared_ptr<tendon::GcmClient> ClientFor(const std::vector<std::string>& words) {
  Settings settings;
  settings.timeout = kCompletionTimeout;
  settings.gcm = program::GcmAddress(Given(words, "--gcm"));
  settings.network.certificate = Given(words, "--certificate");
  settings.network.authority = Given(words, "--ca");
  if (const std::string middleware = Given(words, "--middleware"); !middleware.empty()) {
    settings.network.middleware = middleware;
  }
  settings.network.insecure = std::ranges::find(words, "--insecure") != words.end();
  const auto client = OpenClient(settings, "gcm complete");
  if (!client || !(*client)->WaitUntilWatching()) return nullptr;
  return *client;
}

}  // namespace

int PrintCompletions(const std::vector<std::string>& words, const Streams& streams) {
  const std::vector<std::string> typed(words.begin() + 1, words.end());
  const WordCompletion found =
      Complete(CommandLine({}).page(), typed,
               {.catalogue =
                    [&typed] {
                      const auto client = ClientFor(typed);
                      return client ? client->catalogue() : tendon::Catalogue();
                    },
                .words =
                    [&typed](WordKind kind, const std::vector<std::string>& before) {
                      const auto client = ClientFor(typed);
                      return client ? LiveCompletion(kCompletionTimeout).Of(*client, kind, before)
                                    : std::vector<std::string>();
                    }});
  if (found.is_file) streams.out << ":files\n";
  for (const auto& [text, help] : found.suggestions) {
    const std::size_t end = text.find_last_not_of(' ') + 1;
    streams.out << text.substr(0, end) << (help.empty() ? "" : "\t") << help << '\n';
  }
  return streams.out.flush() ? program::kOk : program::kRefused;
}

std::string CompletionFile(const std::string& shell) {
  static const std::map<std::string, std::string> kFiles = {
      {"bash", kBash}, {"zsh", kZsh}, {"fish", kFish}};
  const auto found = kFiles.find(shell);
  return found == kFiles.end() ? "" : found->second;
}

}  // namespace console
