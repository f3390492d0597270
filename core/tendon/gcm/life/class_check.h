#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/system/plan.h>
#include <tendon/gcm/system_file.h>
#include <tendon/process/life/life_messages.h>

#include <map>
#include <string>
#include <vector>

namespace tendon {

// Checks an order as a process would, from the classes and plug-ins that it reported, before
// anything is done.

/// Whether the process could load the plug-in. kNotFound suggests similar names.
Result<void> CheckPlugIn(const message::Classes& known, const std::string& library);

/// Whether the process has the class of an order to create, and that accepts the configuration.
/// Accepts all for a plug-in that is not loaded, because its classes are unknown.
Result<void> CheckCreation(const message::Classes& known, const message::LifeOrder& order);

/// Whether the class would accept this configuration, JSON or empty. kInvalid says what is wrong.
Result<void> CheckConfiguration(const ClassDescription& of, const std::string& configuration);

/// By process.
using KnownClasses = std::map<std::string, message::Classes>;

/// The processes to ask for their classes before a plan is made: those that are present and have
/// components to create.
[[nodiscard]] std::vector<std::string> ProcessesToAsk(const Catalogue& catalogue,
                                                      const SystemFile& wanted);

/// As MakePlan(), but what CheckCreation() refuses stays as it is and becomes an obstacle, so that
/// a mistake in the file is found before anything is stopped. Checks against the code that
/// processes run; a note tells if the file of a plug-in has changed since.
[[nodiscard]] Plan MakeCheckedPlan(const Catalogue& catalogue, const SystemFile& wanted,
                                   const KnownClasses& known);

}  // namespace tendon
