#pragma once

#include <gcm_gui/inspector/cycle_figures.h>
#include <gcm_gui/views/property_grid.h>
#include <tendon/manager/component_description.h>

#include <QList>

namespace tendon::gui {

/// A few facts that show how well a task keeps its period.
[[nodiscard]] QList<Property> TimingFacts(double period, const CycleFigures& figures);

/// The facts about the thread that runs a component, and about its cycles in the last second.
[[nodiscard]] QList<Property> ThreadFacts(const ComponentDescription& component,
                                          const CycleFigures& figures);

}  // namespace tendon::gui
