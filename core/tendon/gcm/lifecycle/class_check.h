#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/system/plan.h>
#include <tendon/gcm/system_file.h>
#include <tendon/process/lifecycle/lifecycle_messages.h>

#include <map>
#include <string>
#include <vector>

namespace tendon {

// These functions check an order before anything is changed, in the same way as the process will
// check it. They use the classes and plug-ins that the process has reported.

/// Checks that the process can load the plug-in. Fails with kNotFound; the error suggests similar
/// names.
Result<void> CheckPlugIn(const message::Classes& known, const std::string& library);

/// Checks an order to create a component: the process must have the class, and the class must
/// accept the configuration. If the plug-in is not loaded, its classes are unknown, so every class
/// and configuration is accepted.
Result<void> CheckCreation(const message::Classes& known, const message::LifecycleOrder& order);

/// Checks that the class accepts this configuration, which is JSON or empty. Fails with kInvalid;
/// the error says what is wrong.
Result<void> CheckConfiguration(const ClassDescription& of, const std::string& configuration);

/// The classes that processes have reported, by process.
using KnownClasses = std::map<std::string, message::Classes>;

/// Returns the processes that must be asked for their classes before a plan is made. These are the
/// present processes with components to create or to configure.
[[nodiscard]] std::vector<std::string> ProcessesToAsk(const Catalogue& catalogue,
                                                      const SystemFile& wanted);

/// Like MakePlan(), but a component that CheckCreation() refuses stays unchanged and becomes an
/// obstacle. In this way, a mistake in the file is found before components are stopped. The check
/// uses the loaded plug-ins. The plan has a note for each plug-in whose file has changed since it
/// was loaded.
[[nodiscard]] Plan MakeCheckedPlan(const Catalogue& catalogue, const SystemFile& wanted,
                                   const KnownClasses& known);

}  // namespace tendon
