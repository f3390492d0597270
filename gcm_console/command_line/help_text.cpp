#include <gcm_console/command_line/help_text.h>

#include <gcm_console/output/text.h>

#include <algorithm>
#include <sstream>

namespace console {
namespace {

using Row = std::vector<std::string>;

constexpr std::size_t kUsualColumns = 80;
constexpr std::size_t kWidest = 100;  // longer lines are hard to read
constexpr std::size_t kIndent = 2;
constexpr std::size_t kWidestTerm = 26;

std::size_t WidthOf(int columns) {
  constexpr std::size_t kNarrowest = 40;
  if (columns == 0) return kUsualColumns;
  return std::clamp(static_cast<std::size_t>(columns), kNarrowest, kWidest);
}

/// Wraps a text to lines of at most `width` characters. All lines except the first are indented by
/// `indent`.
std::string Wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  std::istringstream words(text);
  std::string lines;
  std::size_t column = indent;
  for (std::string word; words >> word;) {
    const bool is_first = lines.empty();
    if (!is_first && column + 1 + word.size() > width) {
      lines += "\n" + std::string(indent, ' ') + word;
      column = indent + word.size();
      continue;
    }
    lines += (is_first ? "" : " ") + word;
    column += (is_first ? 0 : 1) + word.size();
  }
  return lines + "\n";
}

/// Formats a list of terms with aligned explanations.
std::string Listed(const std::vector<Row>& rows, std::size_t width) {
  std::size_t widest = 0;
  for (const Row& row : rows) {
    if (row.size() > 1) widest = std::max(widest, std::min(row[0].size(), kWidestTerm));
  }
  const std::size_t begin = kIndent + widest + 2;
  const std::string margin(kIndent, ' ');
  std::string text;
  for (const Row& row : rows) {
    if (row.size() == 1) {
      text += margin + Wrapped(row[0], kIndent, width);
      continue;
    }
    const bool fits = row[0].size() <= widest;
    text += margin + row[0];
    text +=
        fits ? std::string(begin - kIndent - row[0].size(), ' ') : "\n" + std::string(begin, ' ');
    text += Wrapped(row[1], begin, width);
  }
  return text;
}

std::vector<Row> RowsOf(const std::vector<Page::Argument>& arguments) {
  std::vector<Row> rows;
  for (const auto& argument : arguments) {
    const std::string only =
        argument.choices.empty() || argument.help.find(", ") != std::string::npos
            ? ""
            : ": " + Joined(argument.choices, ", ");
    rows.push_back({argument.name, argument.help + only});
  }
  return rows;
}

std::vector<Row> RowsOf(const std::vector<Page::Option>& options) {
  std::vector<Row> rows;
  for (const auto& option : options) {
    const std::string value = option.choices.empty() ? option.value : Joined(option.choices, "|");
    rows.push_back({Joined(option.names, ", ") + (value.empty() ? "" : " " + value), option.help});
  }
  return rows;
}

/// Returns the verbs by group. The groups are in the order in which they first appear.
std::vector<std::pair<std::string, std::vector<Row>>> GroupsOf(const std::vector<Page>& parts) {
  std::vector<std::pair<std::string, std::vector<Row>>> groups;
  for (const Page& part : parts) {
    auto known = std::find_if(groups.begin(), groups.end(),
                              [&](const auto& group) { return group.first == part.group; });
    if (known == groups.end()) known = groups.insert(groups.end(), {part.group, {}});
    known->second.push_back({part.last_word(), part.summary});
  }
  return groups;
}

std::vector<Row> RowsOf(const std::vector<Topic>& topics) {
  std::vector<Row> rows;
  for (const Topic& topic : topics) rows.push_back({topic.name, topic.summary});
  return rows;
}

std::vector<Row> RowsOf(const std::vector<std::string>& examples) {
  std::vector<Row> rows;
  for (const std::string& example : examples) rows.push_back({example});
  return rows;
}

bool IsWhole(const Page& page) { return page.name.find(' ') == std::string::npos; }

/// Returns the sections of a page, each with its title.
std::vector<std::pair<std::string, std::vector<Row>>> SectionsOf(const Page& page) {
  auto sections = GroupsOf(page.parts);
  sections.insert(sections.begin(), {"arguments", RowsOf(page.arguments)});
  sections.push_back({"options", RowsOf(page.options)});
  sections.push_back({"examples", RowsOf(page.examples)});
  if (IsWhole(page)) sections.push_back({"topics of gcm help", RowsOf(Topics())});
  return sections;
}

/// Escapes a text for `man`, including characters at the beginning of a line.
std::string Roff(const std::string& text) {
  std::string plain;
  for (const char letter : text) {
    if (letter == '\\') {
      plain += "\\e";
    } else if (letter == '-') {
      plain += "\\-";
    } else {
      plain += letter;
    }
  }
  const bool is_order = plain.starts_with('.') || plain.starts_with('\'');
  return (is_order ? "\\&" : "") + plain;
}

std::string RoffSection(std::string title, const std::vector<Row>& rows) {
  if (rows.empty()) return "";
  std::transform(title.begin(), title.end(), title.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  std::string text = ".SH \"" + Roff(title) + "\"\n";
  for (const Row& row : rows) {
    text += row.size() == 1 ? ".PP\n" + Roff(row[0]) + "\n"
                            : ".TP\n.B " + Roff(row[0]) + "\n" + Roff(row[1]) + "\n";
  }
  return text;
}

}  // namespace

std::string HelpText(const Page& page, int columns) {
  const std::size_t width = WidthOf(columns);
  std::string text = Wrapped(page.name + ": " + page.summary, 0, width) +
                     "\nusage: " + Wrapped(UsageOf(page), 7, width);
  for (const auto& [title, rows] : SectionsOf(page)) {
    if (!rows.empty()) text += "\n" + title + "\n" + Listed(rows, width);
  }
  text += "\n";
  text += Wrapped(
      IsWhole(page)
          ? "Options can be written before or after the verb. Help for a verb: gcm help VERB"
          : "All verbs also accept --gcm, --timeout, --json and other options: gcm help",
      0, width);
  return text;
}

std::string HelpText(const Topic& topic, int columns) {
  const std::size_t width = WidthOf(columns);
  return Wrapped(topic.name + ": " + topic.summary, 0, width) + "\n" + Listed(topic.lines, width);
}

std::string ManualName(const Page& page) {
  std::string name = page.name;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string ManualPage(const Page& page, const std::string& version) {
  std::string text = ".TH \"" + ManualName(page) + "\" 1 \"\" \"tendon " + version + "\"\n";
  text += ".SH NAME\n" + Roff(ManualName(page)) + " \\- " + Roff(page.summary) + "\n";
  text += ".SH SYNOPSIS\n.B " + Roff(UsageOf(page)) + "\n";
  for (const auto& [title, rows] : SectionsOf(page)) text += RoffSection(title, rows);
  if (IsWhole(page)) {
    for (const Topic& topic : Topics()) text += RoffSection(topic.name, topic.lines);
  }
  text += ".SH \"SEE ALSO\"\n";
  return text + (IsWhole(page) ? "gcm\\-VERB(1) of each verb\n" : ".BR gcm (1)\n");
}

const std::vector<Topic>& Topics() {
  static const std::vector<Topic> kTopics = {
      {"exit-codes",
       "the exit codes of gcm",
       {{"0", "done"},
        {"1",
         "refused or failed (the message gives the reason); for connect: the connection is not "
         "made yet"},
        {"2", "the command line is invalid"},
        {"3", "no GCM answers at the address"},
        {"4",
         "the name does not exist, or several objects match; for connect: the GCM has never known "
         "the process"},
        {"5",
         "the two interfaces are not compatible; for plan: only interfaces that are not compatible "
         "prevent the plan"},
        {"6", "no reply in time; the outcome is unknown"},
        {"7", "denied: your role is not sufficient, or a file has unsafe permissions"},
        {"8", "only a part of the command was done"},
        {"130", "interrupted"}}},
      {"paths",
       "how paths and patterns are written",
       {{"process/component/interface.member, or only the first parts of it"},
        {"robot", "a process"},
        {"robot/arm", "a component"},
        {"robot/arm/Control", "an interface, provided or required"},
        {"robot/arm/Control.MoveTo", "a member: a command, event, function or event handler"},
        {"robot/arm/state.Joints", "a column of the component's state table"},
        {"robot/arm/state.Joints.position[0]", "a part of the value of a column"},
        {"In patterns, * matches any characters except / and '.', and ** matches any characters."},
        {"Verbs that need exactly one name do not accept patterns; to list the names that match a "
         "pattern, use gcm find."},
        {"In gcm shell, paths are relative to the path that cd has set. A path that begins with /, "
         "such as /robot/arm, begins at the top. The path .. means one level up."}}},
      {"prompt",
       "the commands of gcm shell besides the verbs",
       {{"cd PATH", "make paths relative to PATH; without PATH, return to the top"},
        {"..", "go one level up"},
        {"VERB &", "run watch, events, hz or log --follow in the background"},
        {"jobs, end NUMBER",
         "jobs lists the background jobs; end ends the job with this number, or all jobs if there "
         "is no number"},
        {"exit", "end the shell and all background jobs"},
        {"VERB; VERB", "run several verbs one after the other"},
        {"# WORDS", "a comment"},
        {"A line may also begin with gcm, as in a terminal."}}},
      {"output",
       "the format of the output, and where it goes",
       {{"Results go to the standard output, messages and errors to the standard error."},
        {"terminal", "tables with column titles; --no-header omits the titles"},
        {"pipe or file", "one line for each row, without titles; the cells are separated by tabs"},
        {"--json",
         "one document with \"schema\": 1; watch, events, hz and log: one document in each line, "
         "for each row, event, log record or gap"},
        {"-q, -v", "-q prints only results and errors; -v prints more messages"},
        {"--color WHEN",
         "when to use colours; auto means on a terminal, unless NO_COLOR is set or TERM is "
         "dumb"}}}};
  return kTopics;
}

}  // namespace console
