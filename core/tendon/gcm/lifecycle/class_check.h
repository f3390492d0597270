#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/system/plan.h>
#include <tendon/gcm/system_file.h>
#include <tendon/process/lifecycle/lifecycle_messages.h>

#include <map>
#include <string>
#include <vector>

namespace tendon {

// Checks an order as the process would check it, from the classes and plug-ins that the process
// reported, before anything is changed.

/// Checks that the process could load the plug-in. kNotFound suggests similar names.
Result<void> CheckPlugIn(const message::Classes& known, const std::string& library);

/// Checks an order to create a component: that the process has the class, and that the class
/// accepts the configuration. Accepts everything for a plug-in that is not loaded, because its
/// classes are unknown.
Result<void> CheckCreation(const message::Classes& known, const message::LifecycleOrder& order);

/// Checks that the class would accept this configuration, which is JSON or empty. The error,
/// kInvalid, says what is wrong.
Result<void> CheckConfiguration(const ClassDescription& of, const std::string& configuration);

/// The reported classes, by process.
using KnownClasses = std::map<std::string, message::Classes>;

/// The processes to ask for their classes before a plan is made: those that are present and have
/// components to create.
[[nodiscard]] std::vector<std::string> ProcessesToAsk(const Catalogue& catalogue,
                                                      const SystemFile& wanted);

/// Like MakePlan(), but components that CheckCreation() refuses stay unchanged and become
/// obstacles, so that a mistake in the file is found before anything is stopped. Checks with the
/// code that is loaded; notes report plug-ins whose file has changed since.
[[nodiscard]] Plan MakeCheckedPlan(const Catalogue& catalogue, const SystemFile& wanted,
                                   const KnownClasses& known);

}  // namespace tendon
