#pragma once

#include <Ice/Ice.h>

namespace tendon::ice {

/// All that our communicators are started with: nothing comes from the environment. Warnings of Ice
/// go to our log, a few at a time.
Ice::InitializationData Settings();

}  // namespace tendon::ice
