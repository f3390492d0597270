#pragma once

#include <tendon/gcm/catalog.h>
#include <tendon/gcm/system/plan.h>
#include <tendon/gcm/system_file.h>
#include <tendon/process/life/messages.h>

#include <map>
#include <string>
#include <vector>

namespace tendon {

// What a process would say of a class, told from the classes and plug-ins that it has: for who
// wants to know before anything is done.

/// Whether the process could load the plug-in. kNotFound names what is near.
Result<void> CheckPlugIn(const message::Classes& known, const std::string& library);

/// Whether it has the class that the order to create names, and the class the configuration. Of a
/// plug-in that is not loaded yet nobody knows the classes: all is right there.
Result<void> CheckCreation(const message::Classes& known, const message::LifeOrder& order);

/// Whether the class could be told that, JSON or empty. kInvalid says what is wrong.
Result<void> CheckConfiguration(const ClassDescription& of, const std::string& configuration);

/// By process.
using KnownClasses = std::map<std::string, message::Classes>;

/// The processes that must be asked for their classes before a plan is made: those that are there
/// and have something to make.
[[nodiscard]] std::vector<std::string> ProcessesToAsk(const Catalog& catalog,
                                                      const SystemFile& wanted);

/// As MakePlan(); but what CheckCreation() refuses stays as it is, and is an obstacle: a mistake in
/// a file is seen before anything is stopped for it. What processes are asked for is what they run:
/// where the file of a plug-in was written again since, that is a note.
[[nodiscard]] Plan MakeCheckedPlan(const Catalog& catalog, const SystemFile& wanted,
                                   const KnownClasses& known);

}  // namespace tendon
