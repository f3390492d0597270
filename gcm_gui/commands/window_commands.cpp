#include <gcm_gui/commands/window_commands.h>

#include <gcm_gui/activity/activity_strip.h>
#include <gcm_gui/activity/redo_stack.h>
#include <gcm_gui/commands/command_palette.h>
#include <gcm_gui/commands/commands.h>
#include <gcm_gui/commands/graph_commands.h>
#include <gcm_gui/diagnosis/diagnosis_binding.h>
#include <gcm_gui/graph/graph_search.h>
#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/help/about.h>
#include <gcm_gui/help/shortcuts_card.h>
#include <gcm_gui/help/tour.h>
#include <gcm_gui/help/window_tour.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/lifecycle/lifecycle_card.h>
#include <gcm_gui/lifecycle/lifecycle_commands.h>
#include <gcm_gui/plot/plot_files.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/recording/window_recording.h>
#include <gcm_gui/replay/recording_opener.h>
#include <gcm_gui/replay/recording_overlay.h>
#include <gcm_gui/replay/window_replay.h>
#include <gcm_gui/system/system_files.h>
#include <gcm_gui/theme/tendon_style.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/catalogue_columns.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gcm_gui/window/gcm_launcher.h>
#include <gcm_gui/window/gcm_switcher.h>
#include <gcm_gui/window/main_window.h>
#include <gcm_gui/window/notice_line.h>
#include <gcm_gui/window/read_only_mode.h>
#include <gcm_gui/window/top_bar.h>

#include <QAbstractButton>
#include <QAction>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>

namespace tendon::gui {
namespace {

/// Makes Space press the button that has the keyboard focus, although Space is also a shortcut.
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

WindowCommands::WindowCommands(MainWindow& window) : QObject(&window), window_(window) {
  commands_ = new Commands(window);
  window_.topBar().addMenus(&commands_->bar());
  addSystemCommands();
  addPlotCommands();
  addRecordingCommands();
  window_.graphCommands().addCommands(*commands_);
  if (window_.replay() != nullptr) {  // its key sets marks there
    commands_->menu(Commands::Menu::kGraph)
        .findChild<QAction*>(Words::tr("Map of the graph"))
        ->setShortcut({});
  }
  QMenu& view = commands_->menu(Commands::Menu::kView);
  window_.panels().fill(view);
  view.addSeparator();
  view.addActions(window_.catalogue().tree().columns().actions());
  connect(&window_.panels(), &Panels::wasReset, &window_.catalogue().tree().columns(),
          &CatalogueColumns::reset);
  view.addSeparator();
  commands_->add(Commands::Menu::kView, Words::tr("Dark or light"), {},
                 [] { Theme::instance().toggle(); });
  addHelpCommands();
  auto* leave = new QAction(&window_);
  leave->setShortcut(Qt::Key_Escape);
  connect(leave, &QAction::triggered, &window_, &MainWindow::escape);
  window_.addAction(leave);
  addPalette();
  if (!window_.parts().read_only.isEmpty()) forbidChanges();
}

void WindowCommands::addRecordingCommands() {
  if (window_.replay() != nullptr) {
    window_.replay()->addCommands(*commands_);
  } else {
    window_.recording().addCommands(*commands_);
  }
  if (!window_.opener().isPossible()) return;
  commands_->menu(Commands::Menu::kRecord).addSeparator();
  commands_->add(Commands::Menu::kRecord, Words::tr("Open a recor&ding…"),
                 QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O),
                 [this] { window_.opener().ask(); });
}

void WindowCommands::addSystemCommands() {
  window_.files().addCommands(*commands_);
  redo_ = new RedoStack(window_.parts().activity, window_.parts().actions, this);
  connect(redo_, &RedoStack::notice, &window_.notice(), &NoticeLine::showNotice);
  connect(&window_.gcmSwitcher(), &GcmSwitcher::notice, &window_.notice(), &NoticeLine::showNotice);
  connect(&window_.gcmLauncher(), &GcmLauncher::notice, &window_.notice(), &NoticeLine::showNotice);
  const auto add = [this](const QString& text, const QKeySequence& key, auto what) {
    commands_->add(Commands::Menu::kSystem, text, key, what);
  };
  add(Words::tr("&Connect…"), Qt::Key_C, [this] { window_.connectSelection(); });
  add(Words::tr("&Disconnect"), Qt::Key_D, [this] { window_.disconnectSelection(); });
  add(Words::tr("&Why is the interface connected, or not?"), Qt::Key_W,
      [this] { window_.diagnosis().open(window_.selection().current()); });
  add(Words::tr("C&all the command…"), {}, [this] { window_.callSelection(); });
  addLifecycleCommands();
  add(Words::tr("&Undo"), QKeySequence::Undo, [this] {
    if (!window_.graphCommands().undoMove()) window_.parts().actions.undo();
  });
  add(Words::tr("&Redo"), QKeySequence(Qt::CTRL | Qt::Key_Y), [this] { redo_->again(); });
  commands_->menu(Commands::Menu::kSystem).addSeparator();
  add(Words::tr("&Filter the catalogue"), QKeySequence::Find, [this] {
    // Opens the search of the part of the window that has the focus.
    window_.graph().isAncestorOf(window_.focusWidget()) || window_.graph().hasFocus()
        ? window_.graphCommands().search().open()
        : window_.catalogue().focusFilter();
  });
  add(Words::tr("&Show in graph and catalogue"), Qt::Key_F4, [this] { window_.revealSelection(); });
  const bool is_live = window_.replay() == nullptr;
  const auto add_live = [&](const QString& text, const QKeySequence& key, auto what) {
    if (is_live) add(text, key, what);
  };
  add_live(Words::tr("Reload everythi&ng"), Qt::Key_F5, [this] {
    const bool is_there = window_.parts().link.state() == LinkState::State::kConnected;
    window_.notice().showNotice(
        is_there ? Words::tr("Everything is loaded from the GCM again")
                 : Words::tr("No GCM answers; the window tries again each second"));
    window_.parts().link.requestResync();
  });
  add(Words::tr("Search or &run…"), QKeySequence(Qt::CTRL | Qt::Key_K),
      [this] { palette_->open(); });
  add_live(Words::tr("C&onsole"), QKeySequence(Qt::CTRL | Qt::Key_J), [this] {
    window_.panels().reveal(window_.strip());
    window_.strip().showConsole();
  });
  commands_->menu(Commands::Menu::kSystem).addSeparator();
  add_live(Words::tr("Connect to another &machine…"), {}, [this] { window_.gcmSwitcher().ask(); });
  add(Words::tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), [this] { window_.close(); });
}

void WindowCommands::addLifecycleCommands() {
  lifecycle_ = new LifecycleCommands(window_.parts().store, window_.selection(),
                                     window_.parts().actions, *window_.centralWidget());
  connect(lifecycle_, &LifecycleCommands::notice, &window_.notice(), &NoticeLine::showNotice);
  lifecycle_->addCommands(*commands_);
  lifecycle_->fillMenu(*commands_, {Words::tr("Connect"), Words::tr("Disconnect"),
                                    Words::tr("Why is the interface connected, or not?"),
                                    Words::tr("Call the command")});
  window_.graphCommands().setComponentMenu(lifecycle_->menu(), window_.selection());
  connect(&window_.catalogue().tree(), &CatalogueTree::menuRequested, lifecycle_,
          [this](const QPoint& place) {
            if (!window_.selection().current().isEmpty()) lifecycle_->menu().popup(place);
          });
}

void WindowCommands::forbidChanges() {
  new ReadOnlyMode(window_.parts().read_only, this);
  window_.connectMode().forbid(window_.parts().read_only);
  QMenu& menu = commands_->menu(Commands::Menu::kSystem);
  menu.setToolTipsVisible(true);
  for (const QString& name :
       {Words::tr("Connect"), Words::tr("Disconnect"), Words::tr("Call the command"),
        Words::tr("Start"), Words::tr("Suspend"), Words::tr("Stop"), Words::tr("Restart"),
        Words::tr("Undo"), Words::tr("Redo")}) {
    auto* action = menu.findChild<QAction*>(name);
    action->setEnabled(false);
    action->setToolTip(window_.parts().read_only);
    if (action->shortcut().isEmpty()) continue;
    // A disabled command ignores its key. This second action has the same key and shows why the
    // command is disabled.
    auto* refusal = new QAction(&window_);
    refusal->setShortcut(action->shortcut());
    connect(refusal, &QAction::triggered, this,
            [this, undoes = action->objectName() == Words::tr("Undo")] {
              if (!undoes || !window_.graphCommands().undoMove())
                window_.notice().showNotice(window_.parts().read_only);
            });
    window_.addAction(refusal);
  }
}

void WindowCommands::addPlotCommands() {
  const auto add = [this](const QString& text, const QKeySequence& key, auto what) -> QAction& {
    return commands_->add(Commands::Menu::kPlot, text, key, what);
  };
  add(Words::tr("&Plot the selection"), Qt::Key_P, [this] { window_.plotSelection(); });
  add(Words::tr("&New plot"), QKeySequence(Qt::CTRL | Qt::Key_T),
      [this] { window_.plots().addPlot(); });
  add(Words::tr("Plot &below, with the same time"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_T),
      [this] { window_.plots().splitPlot(); });
  add(Words::tr("&Rename this plot…"), Qt::Key_F2, [this] { window_.plots().askForName(); });
  add(Words::tr("Close t&his plot"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_W),
      [this] { window_.plots().closePlot(window_.plots().currentIndex()); });
  commands_->menu(Commands::Menu::kPlot).addSeparator();
  // In a recording, Space plays and pauses.
  const QKeySequence pause_key =
      window_.replay() == nullptr ? QKeySequence(Qt::Key_Space) : QKeySequence();
  QAction& pause = add(Words::tr("Pause &view"), pause_key,
                       [this] { window_.plots().setPaused(!window_.plots().isPaused()); });
  pause.setCheckable(true);
  new ButtonsHaveSpace(window_);
  connect(&window_.plots(), &PlotPanel::pausedChanged, &pause, &QAction::setChecked);
  add(Words::tr("Follow &live data"), {},
      [this] { window_.plots().currentPlot().gestures().goLive(); });
  add(Words::tr("Cursors &A and B"), {}, [this] { window_.plots().toggleCursors(); });
  add(Words::tr("Add a curve of a recor&ding…"), {}, [this] { window_.overlay().ask(); });
  commands_->menu(Commands::Menu::kPlot).addSeparator();
  add(Words::tr("&Save the visible samples as CSV…"), QKeySequence(Qt::CTRL | Qt::Key_E),
      [this] { window_.plots().files().askForCsv(); });
  add(Words::tr("Save a p&icture…"), {}, [this] { window_.plots().files().askForPicture(); });
  add(Words::tr("&Open a layout of plots…"), {},
      [this] { window_.plots().files().askForLayout(); });
  add(Words::tr("Save the layou&t of plots…"), {},
      [this] { window_.plots().files().askToSaveLayout(); });
}

void WindowCommands::addHelpCommands() {
  tour_ = new Tour(WindowTour(window_), window_);
  keys_ = new ShortcutsCard(*window_.centralWidget(), *commands_);
  const auto add = [this](const QString& text, auto what) -> QAction& {
    return commands_->add(Commands::Menu::kHelp, text, {}, what);
  };
  add(Words::tr("&Tour of the window"), [this] { tour_->start(); });
  add(Words::tr("&Keys"), [this] { keys_->toggle(); }).setShortcut(Qt::Key_F1);
  add(Words::tr("Keys of &this part"), [this] {
    keys_->toggleOf(window_.focusWidget());
  }).setShortcut(Qt::Key_Question);
  commands_->menu(Commands::Menu::kHelp).addSeparator();
  add(Words::tr("&About gcm-gui"), [this] { ShowAbout(window_); });
}

void WindowCommands::addPalette() {
  palette_ = new CommandPalette(commands_->actions(), window_.catalogueModel(), window_);
  connect(&window_.topBar(), &TopBar::paletteRequested, palette_, &CommandPalette::open);
  connect(palette_, &CommandPalette::pathChosen, &window_, &MainWindow::goTo);
}

bool WindowCommands::closeCard() {
  OverlayCard& lifecycle_card = lifecycle_->card();
  OverlayCard* card = keys_->isVisible() ? keys_ : &lifecycle_card;
  if (!card->isVisible()) return false;
  card->close();
  return true;
}

}  // namespace tendon::gui
