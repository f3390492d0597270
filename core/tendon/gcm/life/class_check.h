#pragma once

#include <tendon/gcm/catalog.h>
#include <tendon/gcm/system/plan.h>
#include <tendon/gcm/system_file.h>
#include <tendon/process/life/messages.h>

#include <map>
#include <string>
#include <vector>

namespace tendon {

/// What a process would refuse to make of a component, as far as its classes and plug-ins tell
/// beforehand: a plug-in that is not there, a class that a loaded plug-in lacks, a configuration
/// that is not of its class. Of a plug-in that is not loaded yet nothing more is known.
Result<void> CheckClass(const message::Classes& known, const std::string& process,
                        const SystemFile::Component& component);

/// By process.
using KnownClasses = std::map<std::string, message::Classes>;

/// The processes that must be asked for their classes before a plan is made: those that are there
/// and have something to make.
[[nodiscard]] std::vector<std::string> ProcessesToAsk(const Catalog& catalog,
                                                      const SystemFile& wanted);

/// As MakePlan(); but what CheckClass() refuses stays as it is, and is an obstacle: a mistake in a
/// file is seen before anything is stopped for it.
[[nodiscard]] Plan MakeCheckedPlan(const Catalog& catalog, const SystemFile& wanted,
                                   const KnownClasses& known);

}  // namespace tendon
