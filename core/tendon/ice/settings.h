#pragma once

#include <Ice/Ice.h>

#include <string>

namespace tendon::ice {

/// All that our communicators are started with: nothing comes from the environment. Warnings of Ice
/// go to our log, a few at a time.
Ice::InitializationData Settings();

/// Ice's messages have several lines; ours have one.
std::string OnOneLine(const std::string& text);

}  // namespace tendon::ice
