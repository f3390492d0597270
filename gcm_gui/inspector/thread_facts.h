#pragma once

#include <gcm_gui/inspector/cycle_figures.h>
#include <gcm_gui/views/fact_grid.h>
#include <tendon/manager/description.h>

#include <QList>

namespace tendon::gui {

/// How well a task keeps a wanted period, in s; in a few lines.
[[nodiscard]] QList<Fact> TimingFacts(double period, const CycleFigures& figures);

/// All about the thread in which a component runs, and how its cycles went in the last second.
[[nodiscard]] QList<Fact> ThreadFacts(const ComponentDescription& component,
                                      const CycleFigures& figures);

}  // namespace tendon::gui
