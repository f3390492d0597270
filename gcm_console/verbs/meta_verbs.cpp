#include <gcm_console/command_line/command_line.h>
#include <gcm_console/command_line/help_text.h>
#include <gcm_console/completion/shell_completion.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/base/name.h>
#include <tendon/middleware/frame.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

namespace console {
namespace {

namespace fs = std::filesystem;

struct HelpOptions {
  std::vector<std::string> words;  // a topic, or a verb with its subcommand
  std::string manual;              // the folder into which all manual pages are written
};

Error NoTopic(const std::string& word, const Page& page) {
  std::vector<std::string> known;
  for (const Page& part : page.parts) known.push_back(part.last_word());
  for (const Topic& topic : Topics()) known.push_back(topic.name);
  const std::string near = tendon::DidYouMean(word, known);
  return {ErrorCode::kInvalid, "no verb or topic '" + word + "'" + near +
                                   (near.empty() ? "; " : " ") +
                                   "to list all verbs and topics: gcm help"};
}

Result<void> WriteManual(const Page& page, const fs::path& folder) {
  const fs::path path = folder / (ManualName(page) + ".1");
  std::ofstream file(path);
  if (!(file << ManualPage(page, TENDON_VERSION) << std::flush)) {
    return Error{ErrorCode::kFailed, "cannot write " + path.string()};
  }
  for (const Page& part : page.parts) {
    if (auto written = WriteManual(part, folder); !written) return written;
  }
  return {};
}

Result<ExitCode> Help(Context& context, const HelpOptions& options) {
  const CommandLine line({});
  const Page all = line.page();
  if (!options.manual.empty()) {
    const auto written = WriteManual(all, options.manual);
    return written ? Result<ExitCode>(program::kOk) : written.error();
  }
  const Page* page = &all;
  for (const std::string& word : options.words) {
    const Page* part = page->Find(word);
    const auto topic = std::find_if(Topics().begin(), Topics().end(),
                                    [&](const Topic& one) { return one.name == word; });
    if (part == nullptr && page == &all && topic != Topics().end()) {
      context.out() << HelpText(*topic, context.columns());
      return program::kOk;
    }
    if (part == nullptr) return NoTopic(word, *page);
    page = part;
  }
  context.out() << HelpText(*page, context.columns());
  return program::kOk;
}

Result<ExitCode> Version(Context& context) {
  const auto protocol = tendon::FrameHeader::kProtocolVersion;
  if (context.settings().json) {
    context.PrintJson({{"version", TENDON_VERSION},
                       {"protocol", protocol},
                       {"middlewares", program::MiddlewareNames()}});
    return program::kOk;
  }
  std::string middlewares;
  for (const std::string& name : program::MiddlewareNames()) {
    middlewares += (middlewares.empty() ? "" : " or ") + name;
  }
  context.out() << VersionLine() << ", protocol " << protocol << ", over " << middlewares << '\n';
  return program::kOk;
}

Verb::Run PrepareHelp(CLI::App& app) {
  auto options = std::make_shared<HelpOptions>();
  WithKind(app.add_option("topic", options->words, "a verb, or a topic: exit-codes, paths, output"),
           WordKind::kVerb);
  WithKind(app.add_option("--manual", options->manual,
                          "instead of help, write manual pages for all verbs into this folder"),
           WordKind::kFile)
      ->check(CLI::ExistingDirectory);
  return [options](Context& context) { return Help(context, *options); };
}

Verb::Run PrepareCompletion(CLI::App& app) {
  auto shell = std::make_shared<std::string>();
  app.add_option("shell", *shell, "which")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  return [shell](Context& context) -> Result<ExitCode> {
    context.out() << CompletionFile(*shell);
    return program::kOk;
  };
}

}  // namespace

std::vector<Verb> MetaVerbs() {
  return {
      {"help",
       "print the list of verbs, or the help of one verb or topic",
       &PrepareHelp,
       {"gcm help watch", "gcm help exit-codes"}},
      {"version", "print the version of gcm and the middlewares that it supports",
       [](CLI::App&) -> Verb::Run { return &Version; }},
      {"completion",
       "print a script that adds completion of gcm commands to a shell",
       &PrepareCompletion,
       {"source <(gcm completion bash)", "gcm completion fish | source"}},
  };
}

}  // namespace console
