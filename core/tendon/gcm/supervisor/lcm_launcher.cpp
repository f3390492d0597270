#include <tendon/gcm/supervisor/lcm_launcher.h>

#include <tendon/base/log.h>
#include <tendon/base/os/child_process.h>
#include <tendon/base/text.h>

#include <algorithm>
#include <fstream>
#include <system_error>
#include <utility>

namespace tendon::server {
namespace {

namespace fs = std::filesystem;

class LcmProcess final : public StartedProcess {
 public:
  explicit LcmProcess(std::unique_ptr<os::BackgroundProgram> program)
      : program_(std::move(program)) {}

  [[nodiscard]] std::int64_t pid() const override { return program_->pid(); }
  std::optional<ProcessEnd> Ended() override {
    const auto end = program_->Ended();
    if (!end) return std::nullopt;
    if (!end->exit_code) return ProcessEnd{true, "was ended by " + end->signal};
    return ProcessEnd{*end->exit_code != 0,
                      "ended with exit code " + std::to_string(*end->exit_code)};
  }
  void Terminate() override { program_->Terminate(); }
  void Kill() override { program_->Kill(); }

 private:
  const std::unique_ptr<os::BackgroundProgram> program_;
};

/// Returns an address at which processes on this host reach the GCM.
std::string Reachable(std::string address) {
  for (const auto& [any, here] :
       {std::pair{"0.0.0.0:", "127.0.0.1:"}, std::pair{"[::]:", "[::1]:"}}) {
    if (address.starts_with(any)) return here + address.substr(std::string(any).size());
  }
  return address;
}

/// Returns the last lines of a file, at most 400 bytes.
std::string EndOf(const fs::path& file) {
  constexpr std::streamoff kMax = 400;
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) return {};
  const std::streamoff size = stream.tellg();
  if (size <= 0) return {};
  stream.seekg(std::max<std::streamoff>(0, size - kMax));
  std::string text(static_cast<std::size_t>(std::min(size, kMax)), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  while (text.ends_with('\n')) text.pop_back();
  const std::size_t line = size > kMax ? text.find('\n') : text.npos;
  if (line != text.npos) text.erase(0, line + 1);
  std::string lines;
  for (const char letter : text)
    lines += letter == '\n' ? std::string(" | ") : std::string(1, letter);
  return Printable(lines);
}

}  // namespace

LcmLauncher::LcmLauncher(LaunchOptions launch, const std::string& gcm, fs::path folder)
    : launch_(std::move(launch)), gcm_(Reachable(gcm)), folder_(std::move(folder)) {}

fs::path LcmLauncher::FileOf(const std::string& process, const std::string& ending) const {
  return folder_ / (process + ending);
}

Result<std::shared_ptr<StartedProcess>> LcmLauncher::Start(const Order& order) {
  if (launch_.program.empty()) {
    return Error{ErrorCode::kFailed,
                 "this GCM cannot start processes; to start this process yourself: lcm --name " +
                     order.process};
  }
  std::error_code reason;
  if (!fs::is_regular_file(launch_.program, reason)) {
    return Error{ErrorCode::kFailed,
                 "there is no " + launch_.program.string() +
                     ": a GCM starts the program lcm from the folder that contains the program of "
                     "the GCM; install lcm in that folder"};
  }
  fs::create_directories(folder_, reason);
  fs::permissions(folder_, fs::perms::owner_all, reason);
  std::vector<std::string> words = {"--name", order.process, "--gcm",
                                    gcm_,     "--timeout",   std::to_string(order.timeout.count())};
  for (std::string& word : launch_.options(order.process)) words.push_back(std::move(word));
  if (order.system) {
    const fs::path file = FileOf(order.process, ".json");
    if (auto written = WriteSystemFile(file, *order.system); !written) return written.error();
    words.insert(words.end(), {"--system", file.string()});
  }
  const fs::path log = FileOf(order.process, ".log");
  const fs::path former = FileOf(order.process, ".log.1");
  fs::rename(log, former, reason);
  if (reason && reason != std::errc::no_such_file_or_directory) {
    Log(LogLevel::kWarning, "gcm",
        "the previous log of process '" + order.process + "', " + log.string() +
            ", could not be kept as " + former.string() + ": " + reason.message());
  }
  shortened_.erase(order.process);
  auto program = os::BackgroundProgram::Start(launch_.program, words, log);
  if (!program) return program.error();
  return std::shared_ptr<StartedProcess>(std::make_shared<LcmProcess>(*std::move(program)));
}

ProcessLog LcmLauncher::LogOf(const std::string& process) {
  const fs::path log = FileOf(process, ".log");
  std::string words = EndOf(log);
  if (words.empty() && shortened_.contains(process)) words = EndOf(FileOf(process, ".log.1"));
  return {words, log.string()};
}

/// The log can be truncated safely, because the process appends to it. If the log cannot be copied,
/// for example because the disk is full, it is truncated nevertheless. Otherwise, it would grow
/// forever.
void LcmLauncher::ShortenLog(const std::string& process) {
  std::error_code reason;
  const fs::path log = FileOf(process, ".log");
  const std::uintmax_t size = fs::file_size(log, reason);
  if (reason || size <= launch_.longest_log) return;
  const fs::path former = FileOf(process, ".log.1");
  fs::copy_file(log, former, fs::copy_options::overwrite_existing, reason);
  const std::string not_kept = reason ? "could not be kept as " + former.string() + " (" +
                                            reason.message() + "), so the previous log is lost"
                                      : "";
  fs::resize_file(log, 0, reason);
  const std::string not_cut =
      reason ? "could not be shortened (" + reason.message() + "), so it keeps growing" : "";
  if (!reason) shortened_.insert(process);
  const std::string both = not_kept.empty() || not_cut.empty() ? "" : "; ";
  Warn(process, not_kept + both + not_cut);
}

/// Logs a warning about the log of a process, unless the last warning about it was the same.
void LcmLauncher::Warn(const std::string& process, const std::string& what) {
  const bool is_new = what != std::exchange(warnings_[process], what);
  if (what.empty() || !is_new) return;
  Log(LogLevel::kWarning, "gcm",
      "the log of process '" + process + "', " + FileOf(process, ".log").string() +
          ", is too long and " + what +
          "; free some disk space, or check who may write in that folder");
}

}  // namespace tendon::server
