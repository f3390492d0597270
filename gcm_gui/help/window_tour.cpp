#include <gcm_gui/help/window_tour.h>

#include <gcm_gui/activity/activity_strip.h>
#include <gcm_gui/inspector/inspector.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/tab_panel.h>
#include <gcm_gui/window/main_window.h>
#include <gcm_gui/window/top_bar.h>

namespace tendon::gui {
namespace {

TourStep Step(const QString& title, const QString& text, std::function<QWidget*()> target) {
  return {title, text, std::move(target)};
}

/// Opens the panel of the widget, and returns the widget.
QWidget* Revealed(MainWindow& window, QWidget& widget) {
  window.panels().reveal(widget);
  return &widget;
}

}  // namespace

std::vector<TourStep> WindowTour(MainWindow& window) {
  return {
      Step(Words::tr("The running system"),
           Words::tr("All processes with their components and interfaces appear here "
                     "automatically; to find one, type into the filter."),
           [&window] { return Revealed(window, window.catalogue()); }),
      Step(Words::tr("Connect with two clicks"),
           Words::tr("Click a hollow port, then a port that lights up: this connects the two "
                     "ports, and Ctrl+Z undoes the connection."),
           [&window]() -> QWidget* {
             window.centre().setCurrent(0);
             return &window.centre();
           }),
      Step(Words::tr("Look inside"),
           Words::tr("Values, commands and events of the selected object are shown here; a click "
                     "on a command opens a form to call it."),
           [&window] { return Revealed(window, window.inspector()); }),
      Step(Words::tr("Plot it live"),
           Words::tr("Select a value and press P: the plot shows all its samples, and you can zoom "
                     "and measure while new ones arrive."),
           [&window]() -> QWidget* { return &window.plots(); }),
      Step(Words::tr("Nothing is lost"),
           Words::tr("Your actions are listed here; you can undo each of them, or copy its command "
                     "line. Other tabs show problems, the log and a console."),
           [&window] { return Revealed(window, window.strip()); }),
      Step(Words::tr("Find everything by name"),
           Words::tr("Ctrl+K finds all commands and all objects. F1 shows the keys. The menu Help "
                     "starts this tour again."),
           [&window] {
             return window.topBar().findChild<QWidget*>(QStringLiteral("searchOrRun"));
           })};
}

}  // namespace tendon::gui
