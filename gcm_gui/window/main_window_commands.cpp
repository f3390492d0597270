#include <gcm_gui/activity/activity_strip.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/why/why_binding.h>
#include <gcm_gui/window/bar/top_bar.h>
#include <gcm_gui/window/commands/command_palette.h>
#include <gcm_gui/window/commands/commands.h>
#include <gcm_gui/window/file/about.h>
#include <gcm_gui/window/file/read_only.h>
#include <gcm_gui/window/file/system_files.h>
#include <gcm_gui/window/main_window.h>

#include <QAction>
#include <QMenu>
#include <QMenuBar>

namespace tendon::gui {

void MainWindow::addCommands() {
  commands_ = new Commands(*this);
  top_bar_->addMenus(&commands_->bar());
  addSystemCommands();
  addPlotCommands();
  panels_->fill(commands_->menu(Commands::Menu::kView));
  commands_->menu(Commands::Menu::kView).addSeparator();
  commands_->add(Commands::Menu::kView, QStringLiteral("Dark or light"), {},
                 [] { Theme::instance().toggle(); });
  commands_->add(Commands::Menu::kView, QStringLiteral("About gcm-gui"), {},
                 [this] { ShowAbout(*this); });
  auto* leave = new QAction(this);
  leave->setShortcut(Qt::Key_Escape);
  connect(leave, &QAction::triggered, this, &MainWindow::escape);
  addAction(leave);
  addPalette();
  if (!parts_.read_only.isEmpty()) forbidChanges();
}

void MainWindow::addSystemCommands() {
  files_->addCommands(*commands_);
  const auto add = [this](const char* text, const QKeySequence& key, auto what) {
    commands_->add(Commands::Menu::kSystem, QString::fromUtf8(text), key, what);
  };
  add("&Connect…", Qt::Key_C, [this] { connectSelection(); });
  add("&Disconnect", Qt::Key_D, [this] { disconnectSelection(); });
  add("&Why is it connected, or not?", Qt::Key_W, [this] { why_->open(selection_.current()); });
  add("C&all the command…", {}, [this] { callSelection(); });
  add("&Undo", QKeySequence::Undo, [this] { parts_.actions.undo(); });
  commands_->menu(Commands::Menu::kSystem).addSeparator();
  add("&Filter the catalogue", QKeySequence::Find, [this] { catalogue_->focusFilter(); });
  add("&Show in graph and catalogue", Qt::Key_F4, [this] { revealSelection(); });
  add("Search or &run…", QKeySequence(Qt::CTRL | Qt::Key_K), [this] { palette_->open(); });
  add("C&onsole", QKeySequence(Qt::CTRL | Qt::Key_J), [this] {
    panels_->reveal(*strip_);
    strip_->showConsole();
  });
  commands_->menu(Commands::Menu::kSystem).addSeparator();
  add("&Quit", QKeySequence(Qt::CTRL | Qt::Key_Q), [this] { close(); });
}

void MainWindow::forbidChanges() {
  new ReadOnly(parts_.read_only, this);
  QMenu& menu = commands_->menu(Commands::Menu::kSystem);
  menu.setToolTipsVisible(true);
  for (const char* name : {"Connect", "Disconnect", "Call the command", "Undo"}) {
    auto* action = menu.findChild<QAction*>(QString::fromLatin1(name));
    action->setEnabled(false);
    action->setToolTip(parts_.read_only);
  }
}

void MainWindow::addPlotCommands() {
  const auto add = [this](const char* text, const QKeySequence& key, auto what) -> QAction& {
    return commands_->add(Commands::Menu::kPlot, QString::fromUtf8(text), key, what);
  };
  add("&Plot what is selected", Qt::Key_P, [this] { plotSelection(); });
  add("&New plot", QKeySequence(Qt::CTRL | Qt::Key_T), [this] { plots_->addPlot(); });
  commands_->menu(Commands::Menu::kPlot).addSeparator();
  QAction& pause =
      add("Pause &view", Qt::Key_Space, [this] { plots_->setPaused(!plots_->isPaused()); });
  pause.setCheckable(true);
  connect(plots_, &PlotPanel::pausedChanged, &pause, &QAction::setChecked);
  add("Follow &live data", {}, [this] { plots_->currentPlot().goLive(); });
  add("Cursors &A and B", {}, [this] { plots_->toggleCursors(); });
  commands_->menu(Commands::Menu::kPlot).addSeparator();
  add("&Save what is seen as CSV…", QKeySequence(Qt::CTRL | Qt::Key_E),
      [this] { plots_->askForCsv(); });
  add("Save a p&icture…", {}, [this] { plots_->askForPicture(); });
  add("&Open a layout of plots…", {}, [this] { plots_->askForLayout(); });
  add("Save the layou&t of plots…", {}, [this] { plots_->askToSaveLayout(); });
}

void MainWindow::addPalette() {
  palette_ = new CommandPalette(commands_->actions(), catalogue_model_, *this);
  connect(top_bar_, &TopBar::paletteRequested, palette_, &CommandPalette::open);
  connect(palette_, &CommandPalette::pathChosen, this, &MainWindow::goTo);
}

}  // namespace tendon::gui
