#include <gcm_console/completion/completer.h>

#include <gcm_console/command_line/command_line.h>
#include <gcm_console/completion/path_completion.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

namespace console {
namespace {

const Page::Option* FindOption(const Page& gcm, const Page& verb, const std::string& name) {
  for (const Page* page : {&verb, &gcm}) {
    for (const auto& option : page->options) {
      if (std::find(option.names.begin(), option.names.end(), name) != option.names.end()) {
        return &option;
      }
    }
  }
  return nullptr;
}

/// The state of a command line before its last word.
struct CompletionContext {
  const Page* page = nullptr;  // the verb, or `gcm` before the verb
  // The option whose value is the last word; null if there is none.
  const Page::Option* option = nullptr;
  std::vector<std::string> arguments = {};  // the arguments of the verb so far
};

CompletionContext CompletionContextOf(const Page& gcm, const std::vector<std::string>& words) {
  CompletionContext context{.page = &gcm};
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const std::string& word = words[i];
    if (std::exchange(context.option, nullptr) != nullptr) continue;
    if (word.starts_with('-') && word.size() > 1) {
      const auto* option = FindOption(gcm, *context.page, word);
      if (option != nullptr && !option->value.empty()) context.option = option;
    } else if (const Page* part = context.page->Find(word)) {
      context.page = part;
    } else {
      context.arguments.push_back(word);
    }
  }
  return context;
}

class Collector {
 public:
  Collector(std::string word, const SystemQueries& system, std::string at)
      : word_(std::move(word)), system_(system), at_(std::move(at)) {}

  /// Adds a suggestion that is a complete word.
  void Offer(const std::string& text, const std::string& help) {
    if (text.starts_with(word_)) found_.suggestions.push_back({text + " ", help});
  }
  void OfferOptions(const Page& page) {
    for (const auto& option : page.options) {
      for (const std::string& name : option.names) {
        const bool is_long = name.starts_with("--");
        if (is_long || option.names.size() == 1) Offer(name, option.help);
      }
    }
  }
  void OfferParts(const Page& page) {
    for (const Page& part : page.parts) Offer(part.last_word(), part.summary);
  }
  /// `before` contains the verb's arguments before this word.
  void OfferValues(WordKind kind, const std::vector<std::string>& choices, const Page& gcm,
                   const std::vector<std::string>& before) {
    for (const std::string& choice : choices) Offer(choice, "");
    if (kind == WordKind::kVerb) OfferParts(gcm);
    if (kind == WordKind::kFile) found_.is_file = true;
    if (IsPath(kind)) OfferPaths(kind);
    if (IsLive(kind)) OfferLive(kind, before);
  }
  WordCompletion Take() { return std::move(found_); }

 private:
  /// Adds words from the live system. Names with dots are completed one level at a time, like
  /// paths. The name of a field is completed before its value.
  void OfferLive(WordKind kind, std::vector<std::string> before) {
    if (!system_.words) return;
    if (!before.empty()) before[0] = ResolvedPath(at_, before[0]);
    const char* ends = kind == WordKind::kParameter ? "." : kind == WordKind::kArgument ? "=" : "";
    std::set<std::string> steps;
    for (const std::string& text : system_.words(kind, before)) {
      if (!text.starts_with(word_)) continue;
      const auto end = text.find_first_of(ends, word_.size());
      steps.insert(end == std::string::npos ? text + " " : text.substr(0, end + 1));
    }
    for (const std::string& step : steps) found_.suggestions.push_back({step, ""});
  }
  /// Adds paths. The typed part stays, and the rest is appended.
  void OfferPaths(WordKind kind) {
    const bool goes_deeper = word_.empty() || word_.ends_with('/');
    std::string prefix = ResolvedPath(at_, word_);
    if (goes_deeper && !prefix.empty()) {
      prefix += std::count(prefix.begin(), prefix.end(), '/') == 2 ? "." : "/";
    }
    if (word_.ends_with("..")) return;
    for (const std::string& path : PathsOf(system_.catalogue(), kind, prefix)) {
      const bool goes_on = path.ends_with('/') || path.ends_with('.');
      found_.suggestions.push_back({word_ + path.substr(prefix.size()) + (goes_on ? "" : " "), ""});
    }
  }

  const std::string word_;
  const SystemQueries& system_;
  const std::string at_;
  WordCompletion found_;
};

/// Completes the value of an option such as "--color="; `value` is the part of the value that was
/// typed.
WordCompletion ValuesBehind(const std::string& begin, const std::string& value, const Page& gcm,
                            const CompletionContext& context, const SystemQueries& system,
                            const std::string& at) {
  const auto* option = FindOption(gcm, *context.page, begin.substr(0, begin.size() - 1));
  if (option == nullptr) return {};
  Collector collector(value, system, at);
  collector.OfferValues(option->kind, option->choices, gcm, context.arguments);
  WordCompletion found = collector.Take();
  for (auto& suggestion : found.suggestions) suggestion.text.insert(0, begin);
  return found;
}

namespace fs = std::filesystem;

/// Returns the files in a folder whose names begin with the last part of `word`.
std::vector<WordCompletion::Suggestion> Files(const std::string& word) {
  const auto slash = word.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : word.substr(0, slash + 1);
  std::vector<WordCompletion::Suggestion> files;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, none)) {
    const std::string path = folder + entry.path().filename().string();
    if (!path.starts_with(word)) continue;
    files.push_back({path + (entry.is_directory(none) ? "/" : " "), ""});
  }
  std::sort(files.begin(), files.end(),
            [](const auto& a, const auto& b) { return a.text < b.text; });
  return files;
}

}  // namespace

WordCompletion Complete(const Page& gcm, const std::vector<std::string>& words,
                        const SystemQueries& system, const std::string& at) {
  const std::string word = words.empty() ? "" : words.back();
  const CompletionContext context = CompletionContextOf(gcm, words);
  if (const auto equals = word.find('=');
      context.option == nullptr && word.starts_with("--") && equals != std::string::npos) {
    return ValuesBehind(word.substr(0, equals + 1), word.substr(equals + 1), gcm, context, system,
                        at);
  }
  Collector collector(word, system, at);
  if (context.option != nullptr) {
    collector.OfferValues(context.option->kind, context.option->choices, gcm, context.arguments);
  } else if (word.starts_with('-')) {
    collector.OfferOptions(*context.page);
    if (context.page != &gcm) collector.OfferOptions(gcm);
  } else if (!context.page->parts.empty()) {
    collector.OfferParts(*context.page);
  } else if (const auto& arguments = context.page->arguments; !arguments.empty()) {
    const std::size_t last = arguments.size() - 1;
    const std::size_t next = context.arguments.size();
    if (next > last && !arguments[last].is_many) return {};
    const auto& argument = arguments[std::min(next, last)];
    collector.OfferValues(argument.kind, argument.choices, gcm, context.arguments);
  }
  return collector.Take();
}

void AddFiles(WordCompletion& completion, const std::string& word) {
  if (!completion.is_file) return;
  const bool is_option = word.starts_with("--") && word.find('=') != word.npos;
  const std::string begin = is_option ? word.substr(0, word.find('=') + 1) : "";
  completion.suggestions = Files(word.substr(begin.size()));
  for (auto& one : completion.suggestions) one.text.insert(0, begin);
}

std::string CommonBegin(const std::vector<WordCompletion::Suggestion>& suggestions) {
  std::string common = suggestions.front().text;
  for (const auto& [text, help] : suggestions) {
    const auto end = std::mismatch(common.begin(), common.end(), text.begin(), text.end());
    common.erase(end.first, common.end());
  }
  return common;
}

}  // namespace console
