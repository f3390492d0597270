#pragma once

#include <Ice/Ice.h>

#include <memory>
#include <string>

namespace tendon::ice {

/// All that our communicators are started with: nothing comes from the environment. Warnings of Ice
/// go to our log, a few at a time.
Ice::InitializationData Settings();

/// One that strangers can reach: its messages are no larger than kMaxPieceSize.
std::shared_ptr<Ice::ObjectAdapter> MakeListeningAdapter(Ice::Communicator& communicator,
                                                         const std::string& name,
                                                         const std::string& endpoints);

/// Ice's messages have several lines; ours have one.
std::string OnOneLine(const std::string& text);

}  // namespace tendon::ice
