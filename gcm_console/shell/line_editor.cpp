#include <gcm_console/shell/line_editor.h>

#include <gcm_console/completion/completer.h>
#include <gcm_console/context.h>
#include <gcm_console/output/table.h>
#include <histedit.h>
#include <tendon/base/os/file.h>
#include <tendon/base/os/keyboard.h>
#include <tendon/base/os/terminal.h>
#include <tendon/base/os/termination.h>

#include <algorithm>
#include <cctype>
#include <clocale>
#include <cstdio>
#include <string_view>
#include <utility>
#include <vector>

namespace console {
namespace {

namespace fs = std::filesystem;

constexpr int kRemembered = 1000;

/// The first line of a history file in the format of libedit.
constexpr const char* kHistoryMark = "_HiStOrY_V2_\n";

/// Encodes a line of the history as strvis() does: \ooo stands for a byte with this octal number.
std::string HistoryLine(const std::string& typed) {
  constexpr std::string_view kPlain = "/.,:;_-+=()[]{}<>\"'*?!#$%&@^|~";
  std::string line;
  for (const char letter : typed) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool is_plain =
        byte < 0x80U && (std::isalnum(byte) != 0 || kPlain.find(letter) != std::string_view::npos);
    if (is_plain) {
      line += letter;
      continue;
    }
    line += '\\';
    for (const unsigned shift : {6U, 3U, 0U}) line += static_cast<char>('0' + (byte >> shift & 7U));
  }
  return line + '\n';
}

/// Uses the user's character set. If the character set is unknown or plain ASCII, uses UTF-8.
/// Otherwise the user could not type other letters.
void ChooseLetters() {
  const char* chosen = std::setlocale(LC_CTYPE, "");
  const std::string_view name = chosen == nullptr ? "C" : chosen;
  if (name == "C" || name == "POSIX") std::setlocale(LC_CTYPE, "C.UTF-8");
}

/// Returns the number of characters in a UTF-8 text.
std::size_t Letters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0U) != 0x80U; }));
}

struct EndEditLine {
  void operator()(EditLine* editor) const { el_end(editor); }
};
struct EndHistory {
  void operator()(History* history) const { history_end(history); }
};

class LineEditor final : public LineReader {
 public:
  LineEditor(fs::path file, AskCompletion completion, AskLines lines)
      : file_(std::move(file)),
        completion_(std::move(completion)),
        lines_(std::move(lines)),
        history_(history_init()),
        editor_(el_init("gcm", stdin, stdout, stderr)) {
    HistEvent event{};
    history(history_.get(), &event, H_SETSIZE, kRemembered);
    history(history_.get(), &event, H_SETUNIQUE, 1);
    Load();
    EditLine* editor = editor_.get();
    el_set(editor, EL_CLIENTDATA, this);
    el_set(editor, EL_PROMPT, &Prompt);
    el_set(editor, EL_SIGNAL, 1);  // restores the terminal if a signal ends the program
    el_set(editor, EL_EDITOR, "emacs");
    el_set(editor, EL_HIST, &::history, history_.get());
    el_set(editor, EL_GETCFN, &OnLetter);
    el_set(editor, EL_ADDFN, "gcm-complete", "complete a word", &OnTab);
    el_set(editor, EL_ADDFN, "gcm-abandon", "begin anew", &OnInterrupt);
    el_set(editor, EL_BIND, "^R", "em-inc-search-prev", nullptr);
    el_source(editor, nullptr);
    el_set(editor, EL_BIND, "^I", "gcm-complete", nullptr);
    el_set(editor, EL_BIND, "^C", "gcm-abandon", nullptr);
    // With this setting, Ctrl-C is an ordinary key while a line is edited.
    el_set(editor, EL_SETTY, "-d", "-isig", nullptr);
  }

  std::optional<std::string> Read(const std::string& prompt) override {
    prompt_ = prompt;
    el_set(editor_.get(), EL_PREP_TERM, 1);  // before the prompt: from now on Ctrl-C is a key
    tendon::os::ForgetInterrupt();           // an earlier Ctrl-C concerned the previous command
    const tendon::os::TerminationUnblockScope while_typing;
    int count = 0;
    const char* typed = el_gets(editor_.get(), &count);
    if (std::exchange(is_abandoned_, false)) return "";
    if (typed == nullptr || count <= 0) return std::nullopt;
    std::string line(typed, static_cast<std::size_t>(count));
    while (line.ends_with('\n') || line.ends_with('\r')) line.pop_back();
    Remember(line);
    return line;
  }

 private:
  static LineEditor& Of(EditLine* editor) {
    void* self = nullptr;
    el_get(editor, EL_CLIENTDATA, &self);
    return *static_cast<LineEditor*>(self);
  }
  static char* Prompt(EditLine* editor) { return Of(editor).prompt_.data(); }
  static int OnLetter(EditLine* editor, wchar_t* letter) { return Of(editor).ReadLetter(letter); }
  static unsigned char OnTab(EditLine* editor, int /*key*/) { return Of(editor).Complete(); }
  static unsigned char OnInterrupt(EditLine* editor, int /*key*/) {
    Of(editor).is_abandoned_ = true;
    std::fputs("^C\n", stdout);
    std::fflush(stdout);
    return CC_NEWLINE;
  }

  /// Reads a character for libedit. While it waits, prints the lines that arrive.
  int ReadLetter(wchar_t* letter) {
    constexpr std::chrono::milliseconds kTurn(50);
    while (ShowLines() && !tendon::os::IsKeyPressed(kTurn)) {
    }
    el_set(editor_.get(), EL_GETCFN, EL_BUILTIN_GETCFN);
    const int count = el_wgetc(editor_.get(), letter);
    el_set(editor_.get(), EL_GETCFN, &OnLetter);
    return count;
  }
  /// Prints the lines of background jobs. Returns false if there will be no more lines.
  bool ShowLines() {
    const auto lines = lines_();
    if (lines && !lines->empty()) {
      std::fputs((Erasure() + *lines).c_str(), stdout);
      std::fflush(stdout);
      el_set(editor_.get(), EL_REFRESH);
    }
    return lines.has_value();
  }
  /// Returns the text that erases the prompt and the typed line. On a dumb terminal, this is a line
  /// break.
  [[nodiscard]] std::string Erasure() const {
    if (IsDumbTerminal()) return "\n";
    const LineInfo* info = el_line(editor_.get());
    const auto typed =
        Letters({info->buffer, static_cast<std::size_t>(info->cursor - info->buffer)});
    const auto columns = std::max(1, tendon::os::TerminalColumns(tendon::os::Stream::kOutput));
    const auto rows = (Letters(prompt_) + typed) / static_cast<std::size_t>(columns);
    return (rows > 0 ? "\x1b[" + std::to_string(rows) + "A" : "") + "\r\x1b[J";
  }

  /// Loads the history. If the file has become long, removes its oldest lines.
  void Load() {
    HistEvent event{};
    const int loaded = history(history_.get(), &event, H_LOAD, file_.c_str());
    if (loaded > 2 * kRemembered) history(history_.get(), &event, H_SAVE, file_.c_str());
    std::error_code none;
    const auto size = fs::file_size(file_, none);
    if (none || size == 0) static_cast<void>(tendon::os::AppendDurably(file_, kHistoryMark));
    fs::permissions(file_, fs::perms::owner_read | fs::perms::owner_write, none);
  }

  /// Appends the line to the file. The file is not replaced, because other shells write to it, too.
  void Remember(const std::string& line) {
    if (line.find_first_not_of(" \t") == std::string::npos) return;
    HistEvent event{};
    history(history_.get(), &event, H_ENTER, line.c_str());
    static_cast<void>(tendon::os::AppendDurably(file_, HistoryLine(line)));
  }

  unsigned char Complete() {
    const LineInfo* info = el_line(editor_.get());
    const PartialCommand line =
        ParsePartialCommand({info->buffer, static_cast<std::size_t>(info->cursor - info->buffer)});
    const std::string& word = line.words.back();
    WordCompletion found = completion_(line);
    AddFiles(found, word);
    if (found.suggestions.empty()) return CC_REFRESH_BEEP;
    const std::string common = CommonBegin(found.suggestions);
    if (common.size() > word.size()) {
      Replace(line, common, found.suggestions.size() == 1);
      return CC_REFRESH;
    }
    List(found.suggestions);
    return CC_REDISPLAY;
  }

  /// Replaces the last word of the line by its completion. Keeps the part that the user has typed
  /// if possible.
  void Replace(const PartialCommand& line, const std::string& common, bool is_only_one) {
    const std::string& word = line.words.back();
    const bool is_whole = is_only_one && common.ends_with(' ');
    const std::string wanted = QuoteWord(common.substr(0, common.size() - (is_whole ? 1 : 0)));
    std::string more = is_whole ? " " : "";
    if (word == line.typed && wanted.starts_with(word)) {
      more.insert(0, wanted.substr(word.size()));
    } else {
      el_deletestr(editor_.get(), static_cast<int>(Letters(line.typed)));
      more.insert(0, wanted);
    }
    el_insertstr(editor_.get(), more.c_str());
  }

  static void List(const std::vector<WordCompletion::Suggestion>& suggestions) {
    std::size_t widest = 0;
    for (const auto& [text, help] : suggestions) widest = std::max(widest, text.size());
    std::fputc('\n', stdout);
    for (const auto& [text, help] : suggestions) {
      std::fprintf(stdout, "%-*s  %s\n", static_cast<int>(widest), Plain(text).c_str(),
                   Plain(help).c_str());
    }
    std::fflush(stdout);
  }

  const fs::path file_;
  const AskCompletion completion_;
  const AskLines lines_;
  const std::unique_ptr<History, EndHistory> history_;
  const std::unique_ptr<EditLine, EndEditLine> editor_;
  std::string prompt_;
  bool is_abandoned_ = false;
};

}  // namespace

std::unique_ptr<LineReader> MakeLineEditor(const fs::path& history, AskCompletion completion,
                                           AskLines lines) {
  ChooseLetters();
  return std::make_unique<LineEditor>(history, std::move(completion), std::move(lines));
}

}  // namespace console
