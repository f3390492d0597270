#pragma once

#include <gcm_gui/help/tour.h>

#include <vector>

namespace tendon::gui {

class MainWindow;

/// Returns the steps of the tour for new users. They are valid as long as `window` exists.
[[nodiscard]] std::vector<TourStep> WindowTour(MainWindow& window);

}  // namespace tendon::gui
