#include <gcm_gui/activity/activity_strip.h>
#include <gcm_gui/activity/redo.h>
#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/graph/search/graph_search.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/theme/tendon_style.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/tour/tour.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gcm_gui/views/columns/catalogue_columns.h>
#include <gcm_gui/why/why_binding.h>
#include <gcm_gui/window/bar/notice_line.h>
#include <gcm_gui/window/bar/top_bar.h>
#include <gcm_gui/window/commands/command_palette.h>
#include <gcm_gui/window/commands/commands.h>
#include <gcm_gui/window/file/gcm_start.h>
#include <gcm_gui/window/file/other_gcm.h>
#include <gcm_gui/window/file/read_only.h>
#include <gcm_gui/window/file/system_files.h>
#include <gcm_gui/window/graph/graph_commands.h>
#include <gcm_gui/window/help/about.h>
#include <gcm_gui/window/help/keys_card.h>
#include <gcm_gui/window/help/window_tour.h>
#include <gcm_gui/window/main_window.h>
#include <gcm_gui/window/steer/steer_commands.h>

#include <QAbstractButton>
#include <QAction>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>

namespace tendon::gui {
namespace {

/// Space presses a button with the keyboard focus, even if Space is a shortcut.
class ButtonsHaveSpace : public QObject {
 public:
  explicit ButtonsHaveSpace(QWidget& window) : QObject(&window), window_(window) {
    window.installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) {
      const auto* button = qobject_cast<const QAbstractButton*>(window_.focusWidget());
      if (button != nullptr && HasKeyboardFocus(*button)) {
        event->accept();
        return true;
      }
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  QWidget& window_;
};

}  // namespace

void MainWindow::addCommands() {
  commands_ = new Commands(*this);
  top_bar_->addMenus(&commands_->bar());
  addSystemCommands();
  addPlotCommands();
  graph_commands_->addCommands(*commands_);
  QMenu& view = commands_->menu(Commands::Menu::kView);
  panels_->fill(view);
  view.addSeparator();
  view.addActions(catalogue_->tree().columns().actions());
  connect(panels_, &Panels::wasReset, &catalogue_->tree().columns(), &CatalogueColumns::reset);
  view.addSeparator();
  commands_->add(Commands::Menu::kView, Words::tr("Dark or light"), {},
                 [] { Theme::instance().toggle(); });
  addHelpCommands();
  auto* leave = new QAction(this);
  leave->setShortcut(Qt::Key_Escape);
  connect(leave, &QAction::triggered, this, &MainWindow::escape);
  addAction(leave);
  addPalette();
  if (!parts_.read_only.isEmpty()) forbidChanges();
}

void MainWindow::addSystemCommands() {
  files_->addCommands(*commands_);
  redo_ = new Redo(parts_.activity, parts_.actions, this);
  connect(redo_, &Redo::notice, notice_, &NoticeLine::tell);
  connect(other_, &OtherGcm::notice, notice_, &NoticeLine::tell);
  connect(gcm_start_, &GcmStart::notice, notice_, &NoticeLine::tell);
  const auto add = [this](const QString& text, const QKeySequence& key, auto what) {
    commands_->add(Commands::Menu::kSystem, text, key, what);
  };
  add(Words::tr("&Connect…"), Qt::Key_C, [this] { connectSelection(); });
  add(Words::tr("&Disconnect"), Qt::Key_D, [this] { disconnectSelection(); });
  add(Words::tr("&Why is it connected, or not?"), Qt::Key_W,
      [this] { why_->open(selection_.current()); });
  add(Words::tr("C&all the command…"), {}, [this] { callSelection(); });
  addSteerCommands();
  add(Words::tr("&Undo"), QKeySequence::Undo, [this] {
    if (!graph_commands_->undoMove()) parts_.actions.undo();
  });
  add(Words::tr("&Redo"), QKeySequence(Qt::CTRL | Qt::Key_Y), [this] { redo_->again(); });
  commands_->menu(Commands::Menu::kSystem).addSeparator();
  add(Words::tr("&Filter the catalogue"), QKeySequence::Find, [this] {
    // Searches in the part of the window that has the focus.
    graph_->isAncestorOf(focusWidget()) || graph_->hasFocus() ? graph_commands_->search().open()
                                                              : catalogue_->focusFilter();
  });
  add(Words::tr("&Show in graph and catalogue"), Qt::Key_F4, [this] { revealSelection(); });
  add(Words::tr("Reload everythi&ng"), Qt::Key_F5, [this] {
    const bool is_there = parts_.link.state() == LinkState::State::kConnected;
    notice_->tell(is_there ? Words::tr("Everything is loaded from the GCM again")
                           : Words::tr("No GCM answers; the window tries again each second"));
    parts_.link.askAnew();
  });
  add(Words::tr("Search or &run…"), QKeySequence(Qt::CTRL | Qt::Key_K),
      [this] { palette_->open(); });
  add(Words::tr("C&onsole"), QKeySequence(Qt::CTRL | Qt::Key_J), [this] {
    panels_->reveal(*strip_);
    strip_->showConsole();
  });
  commands_->menu(Commands::Menu::kSystem).addSeparator();
  add(Words::tr("Connect to another &machine…"), {}, [this] { other_->ask(); });
  add(Words::tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), [this] { close(); });
}

void MainWindow::addSteerCommands() {
  steer_ = new SteerCommands(parts_.store, selection_, parts_.actions, *centralWidget());
  connect(steer_, &SteerCommands::notice, notice_, &NoticeLine::tell);
  steer_->addCommands(*commands_);
  steer_->fillMenu(*commands_,
                   {Words::tr("Connect"), Words::tr("Disconnect"),
                    Words::tr("Why is it connected, or not?"), Words::tr("Call the command")});
  graph_commands_->setComponentMenu(steer_->menu(), selection_);
  connect(&catalogue_->tree(), &CatalogueTree::menuRequested, steer_, [this](const QPoint& place) {
    if (!selection_.current().isEmpty()) steer_->menu().popup(place);
  });
}

void MainWindow::forbidChanges() {
  new ReadOnly(parts_.read_only, this);
  mode_.forbid(parts_.read_only);
  QMenu& menu = commands_->menu(Commands::Menu::kSystem);
  menu.setToolTipsVisible(true);
  for (const QString& name :
       {Words::tr("Connect"), Words::tr("Disconnect"), Words::tr("Call the command"),
        Words::tr("Start"), Words::tr("Suspend"), Words::tr("Stop"), Words::tr("Restart"),
        Words::tr("Undo"), Words::tr("Redo")}) {
    auto* action = menu.findChild<QAction*>(name);
    action->setEnabled(false);
    action->setToolTip(parts_.read_only);
    if (action->shortcut().isEmpty()) continue;
    auto* refusal = new QAction(this);  // so that its key also shows the reason
    refusal->setShortcut(action->shortcut());
    connect(refusal, &QAction::triggered, this,
            [this, undoes = action->objectName() == Words::tr("Undo")] {
              if (!undoes || !graph_commands_->undoMove()) notice_->tell(parts_.read_only);
            });
    addAction(refusal);
  }
}

void MainWindow::addPlotCommands() {
  const auto add = [this](const QString& text, const QKeySequence& key, auto what) -> QAction& {
    return commands_->add(Commands::Menu::kPlot, text, key, what);
  };
  add(Words::tr("&Plot the selection"), Qt::Key_P, [this] { plotSelection(); });
  add(Words::tr("&New plot"), QKeySequence(Qt::CTRL | Qt::Key_T), [this] { plots_->addPlot(); });
  add(Words::tr("Plot &below, with the same time"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_T),
      [this] { plots_->splitPlot(); });
  add(Words::tr("&Rename this plot…"), Qt::Key_F2, [this] { plots_->askForName(); });
  add(Words::tr("Close t&his plot"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_W),
      [this] { plots_->closePlot(plots_->currentIndex()); });
  commands_->menu(Commands::Menu::kPlot).addSeparator();
  QAction& pause = add(Words::tr("Pause &view"), Qt::Key_Space,
                       [this] { plots_->setPaused(!plots_->isPaused()); });
  pause.setCheckable(true);
  new ButtonsHaveSpace(*this);
  connect(plots_, &PlotPanel::pausedChanged, &pause, &QAction::setChecked);
  add(Words::tr("Follow &live data"), {}, [this] { plots_->currentPlot().goLive(); });
  add(Words::tr("Cursors &A and B"), {}, [this] { plots_->toggleCursors(); });
  commands_->menu(Commands::Menu::kPlot).addSeparator();
  add(Words::tr("&Save the visible samples as CSV…"), QKeySequence(Qt::CTRL | Qt::Key_E),
      [this] { plots_->askForCsv(); });
  add(Words::tr("Save a p&icture…"), {}, [this] { plots_->askForPicture(); });
  add(Words::tr("&Open a layout of plots…"), {}, [this] { plots_->askForLayout(); });
  add(Words::tr("Save the layou&t of plots…"), {}, [this] { plots_->askToSaveLayout(); });
}

void MainWindow::addHelpCommands() {
  tour_ = new Tour(WindowTour(*this), *this);
  keys_ = new KeysCard(*centralWidget(), *commands_);
  const auto add = [this](const QString& text, auto what) -> QAction& {
    return commands_->add(Commands::Menu::kHelp, text, {}, what);
  };
  add(Words::tr("&Tour of the window"), [this] { tour_->start(); });
  add(Words::tr("&Keys"), [this] { keys_->toggle(); }).setShortcut(Qt::Key_F1);
  add(Words::tr("Keys of &this part"), [this] {
    keys_->toggleOf(focusWidget());
  }).setShortcut(Qt::Key_Question);
  commands_->menu(Commands::Menu::kHelp).addSeparator();
  add(Words::tr("&About gcm-gui"), [this] { ShowAbout(*this); });
}

void MainWindow::addPalette() {
  palette_ = new CommandPalette(commands_->actions(), catalogue_model_, *this);
  connect(top_bar_, &TopBar::paletteRequested, palette_, &CommandPalette::open);
  connect(palette_, &CommandPalette::pathChosen, this, &MainWindow::goTo);
}

}  // namespace tendon::gui
