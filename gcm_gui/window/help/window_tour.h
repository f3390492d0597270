#pragma once

#include <gcm_gui/tour/tour.h>

#include <vector>

namespace tendon::gui {

class MainWindow;

/// What a newcomer is shown of the window, in that order. The steps are of use as long as the
/// window is there.
[[nodiscard]] std::vector<TourStep> WindowTour(MainWindow& window);

}  // namespace tendon::gui
