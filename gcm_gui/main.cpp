#include <gcm_gui/files/saved_settings.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/guard/guarded_application.h>
#include <gcm_gui/help/tour.h>
#include <gcm_gui/language/language.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/plot_files.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/recording/window_recording.h>
#include <gcm_gui/replay/replay_session.h>
#include <gcm_gui/session/gcm_session.h>
#include <gcm_gui/session/hosted_gcm.h>
#include <gcm_gui/system/system_files.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/catalogue_columns.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gcm_gui/window/main_window.h>
#include <gcm_gui/window/ui_description.h>
#include <gcm_gui/window/watched_application.h>
#include <program/exit_code.h>
#include <program/lcm_launch_options.h>
#include <program/network_options.h>
#include <tendon/base/os/process.h>
#include <tendon/base/os/termination.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/connect_cancellation.h>
#include <tendon/process/version_messages.h>

#include <CLI/CLI.hpp>
#include <QMetaObject>
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <thread>

namespace {

constexpr auto kReadOnly = QT_TRANSLATE_NOOP(
    "Words", "this window cannot change anything: it was started with --read-only");

struct Options {
  std::string gcm;
  std::string listen;
  std::string file;
  bool read_only = false;
  bool no_tour = false;
  std::string layout;
  std::string theme = "system";
  program::NetworkOptions network;
  std::string describe_ui;
};

void AddOptions(CLI::App& app, Options& options) {
  auto* gcm =
      program::AddGcmOption(app, options.gcm, "; with this option, the window never hosts a GCM");
  app.set_version_flag("--version", "gcm-gui " + tendon::OwnVersion().release);
  app.add_option("--listen", options.listen, "host a GCM at this address")->excludes(gcm);
  app.add_option(
      "file", options.file,
      "system file to apply, after the window has shown its plan; or a recording (.mcap), "
      "which the window shows without a running system");
  app.add_flag("--read-only", options.read_only,
               "connect with the role viewer, which cannot change anything");
  app.add_option("--layout", options.layout,
                 "layout of the plots at the start: a file that the window has saved")
      ->check(CLI::ExistingFile)
      ->type_name("FILE");
  app.add_flag("--no-tour", options.no_tour,
               "do not show the tour, even if this user opens the window for the first time");
  app.add_option("--theme", options.theme, "dark, light or system")
      ->check(CLI::IsMember({"dark", "light", "system"}))
      ->capture_default_str();
  program::AddNetworkOptions(app, options.network);
  app.add_option("--describe-ui", options.describe_ui,
                 "write the positions of objects on the screen to this file, for UI tests");
}

tendon::gui::Theme::Choice ThemeChoice(const std::string& name) {
  using Choice = tendon::gui::Theme::Choice;
  if (name == "dark") return Choice::kDark;
  return name == "light" ? Choice::kLight : Choice::kSystem;
}

int Fail(const tendon::Error& error) {
  std::cerr << "gcm-gui: " << error.message << std::endl;
  return program::ExitCodeOf(error.code);
}

/// Returns false if there is no display, because Qt would then abort. QT_QPA_PLATFORM may name a
/// platform that needs no display.
bool HasDisplay() {
  return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
         qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
}

/// Restores the layout of the last run, and saves changes from now on.
void KeepLayout(tendon::gui::MainWindow& window, tendon::gui::SavedSettings& kept) {
  const auto geometry = QStringLiteral("geometry");
  const auto panels = QStringLiteral("panels");
  const auto columns = QStringLiteral("catalogueColumns");
  const auto recording = QStringLiteral("recording");
  // Invalid saved values must not prevent the window from opening.
  const auto restore = [&](QWidget& view, auto&& part) {
    tendon::gui::ExceptionGuard::run(&view, tendon::gui::ViewWork::kHandling, part);
  };
  restore(window, [&] { window.restoreGeometry(kept.value(geometry)); });
  restore(window, [&] { window.panels().restore(kept.value(panels)); });
  restore(window.catalogue(),
          [&] { window.catalogue().tree().columns().restore(kept.value(columns)); });
  restore(window, [&] { window.recording().controller().restoreChoices(kept.value(recording)); });
  QObject::connect(qApp, &QCoreApplication::aboutToQuit, &window,
                   [&window, &kept, geometry, panels, columns, recording] {
                     tendon::gui::ExceptionGuard::run(
                         &window, tendon::gui::ViewWork::kHandling, [&] {
                           kept.set(geometry, window.saveGeometry());
                           kept.set(panels, window.panels().state());
                           kept.set(columns, window.catalogue().tree().columns().state());
                           kept.set(recording, window.recording().controller().choices());
                         });
                   });
}

/// Returns the path of the demo. It is relative to the programs, in the build as well as when
/// installed.
QString DemoFile() {
  const auto prefix = tendon::os::ProgramFolder().parent_path();
  return QString::fromStdString((prefix / "share/tendon/systems/demo.json").string());
}

/// Starts the tour if this user has never seen it.
void ShowAroundOnce(tendon::gui::MainWindow& window, tendon::gui::SavedSettings& kept) {
  const auto seen = QStringLiteral("shownAround");
  if (!kept.value(seen).isEmpty()) return;
  window.tour().start();
  kept.set(seen, "yes");
}

/// Ends the event loop when SIGINT or SIGTERM arrives, so that a recording is completed. Uses its
/// own thread, so that a second signal ends the program even if the event loop hangs.
class SignalWatch {
 public:
  SignalWatch() : thread_([this] { watch(); }) {}
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;
  ~SignalWatch() {
    is_ended_.Set(true);
    thread_.join();
  }

 private:
  void watch() {
    constexpr std::chrono::milliseconds kOften{200};
    while (!is_ended_.Get() && !tendon::os::TerminationRequested(kOften)) {
    }
    if (is_ended_.Get()) return;
    QMetaObject::invokeMethod(
        qApp, [] { QCoreApplication::exit(program::kInterrupted); }, Qt::QueuedConnection);
    // Keeps the thread alive: a second signal can reach only this thread.
    while (!is_ended_.Get()) std::this_thread::sleep_for(kOften);
  }

  tendon::Flag is_ended_;
  std::thread thread_;
};

/// Returns the command that starts a GCM for this window. Returns an empty list for a read-only
/// window. Also returns an empty list under TLS, because a GCM needs its own certificate.
QStringList GcmCommand(const Options& options) {
  if (options.read_only || !options.network.certificate.empty()) return {};
  QStringList command{QString::fromStdString((tendon::os::ProgramFolder() / "gcm").string())};
  for (const std::string& word : program::LcmLaunchOptions(options.network).options("gcm")) {
    command.append(QString::fromStdString(word));
  }
  return command;
}

/// Returns the command that opens a recording in another window.
QStringList ViewerCommand(const Options& options) {
  const auto program = tendon::os::ProgramFolder() / "gcm-gui";
  return {QString::fromStdString(program.string()), QStringLiteral("--theme"),
          QString::fromStdString(options.theme)};
}

bool IsRecording(const std::string& file) {
  return QString::fromStdString(file).endsWith(QStringLiteral(".mcap"), Qt::CaseInsensitive);
}

QString KeptFolder() {
  const auto kept = tendon::os::StateFolder().parent_path() / "gcm-gui";
  return QString::fromStdString(kept.string());
}

/// Shows the window with the kept layout, and with the plots of `options`.
void ShowWindow(tendon::gui::MainWindow& window, tendon::gui::SavedSettings& values,
                const Options& options) {
  if (!options.describe_ui.empty()) {
    new tendon::gui::UiDescription(window, QString::fromStdString(options.describe_ui));
  }
  KeepLayout(window, values);
  window.show();
  if (!options.layout.empty())
    window.plots().files().openLayout(QString::fromStdString(options.layout));
}

/// Shows a recording, with no connection to any running system.
int RunReplay(const Options& options) {
  tendon::gui::ReplaySession session(QString::fromStdString(options.file));
  auto parts = tendon::gui::PartsOf(session);
  parts.kept = KeptFolder();
  parts.viewer = ViewerCommand(options);
  tendon::gui::SavedSettings values(parts.kept + QStringLiteral("/replay-window.json"));
  tendon::gui::MainWindow window(parts);
  ShowWindow(window, values, options);
  const int code = tendon::gui::GuardedApplication::exec();
  window.hide();
  return code;
}

int Run(const Options& options) {
  std::optional<tendon::ConnectCancellation> end;  // must outlive everything that opens links
  const auto middleware = program::MakeMiddleware(options.network);
  if (!middleware) return Fail(middleware.error());

  std::string address = options.listen.empty() ? program::GcmAddress(options.gcm) : options.listen;
  const bool given = !options.gcm.empty() || qEnvironmentVariableIsSet("TENDON_GCM");
  std::unique_ptr<tendon::gui::HostedGcm> hosted;
  if (!given || !options.listen.empty()) {
    auto started = tendon::gui::HostedGcm::Start(*middleware, address,
                                                 program::LcmLaunchOptions(options.network));
    if (started) {
      hosted = std::move(*started);
      address = hosted->address();
    } else if (!options.listen.empty() || started.error().code != tendon::ErrorCode::kExists) {
      return Fail(started.error());
    }
  }

  tendon::gui::GcmSession session(
      *middleware, address, hosted != nullptr,
      options.read_only ? tendon::Role::kViewer : tendon::Role::kOperator);
  auto parts = tendon::gui::PartsOf(session);
  parts.console.gcm = address;
  parts.console.network = options.network;
  parts.console.read_only = options.read_only;
  parts.console.color = console::ColorChoice::kNever;
  parts.kept = KeptFolder();
  parts.viewer = ViewerCommand(options);
  parts.gcm = GcmCommand(options);
  parts.demo = DemoFile();
  if (options.read_only) parts.read_only = tendon::gui::Words::tr(kReadOnly);
  tendon::gui::SavedSettings values(parts.kept + QStringLiteral("/window.json"));
  tendon::gui::MainWindow window(parts);
  ShowWindow(window, values, options);
  if (!options.no_tour && options.file.empty()) ShowAroundOnce(window, values);
  if (!options.file.empty()) window.files().bringUp(QString::fromStdString(options.file));
  const int code = tendon::gui::GuardedApplication::exec();
  // Cancels connection attempts. Otherwise a process that hangs would delay the end of the program.
  end.emplace();
  window.hide();
  session.recordings().complete();
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  tendon::os::HoldTerminationSignals();  // before any thread starts
  Options options;
  CLI::App app("Shows and controls a running system.", "gcm-gui");
  AddOptions(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? program::kOk : program::kUsage;
  }
  if (!HasDisplay()) {
    return Fail({tendon::ErrorCode::kFailed,
                 "there is no display (neither DISPLAY nor WAYLAND_DISPLAY is set); in a terminal "
                 "use gcm, and host a GCM with: gcm serve"});
  }
  tendon::gui::WatchedApplication application(argc, argv);
  const SignalWatch signal_watch;
  tendon::gui::ExceptionGuard::instance();  // created before any thread that may need it
  QApplication::setApplicationName("gcm-gui");
  QApplication::setOrganizationName("tendon");
  tendon::gui::SetLanguage(QLocale::system());
  tendon::gui::Theme::instance().choose(ThemeChoice(options.theme));
  try {
    return IsRecording(options.file) ? RunReplay(options) : Run(options);
  } catch (const std::exception& error) {  // there is no window yet that could show the error
    return Fail({tendon::ErrorCode::kFailed, error.what()});
  }
}
