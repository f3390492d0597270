#pragma once

#include <Ice/Ice.h>

#include <memory>
#include <string>

namespace tendon::ice {

/// Returns the settings of all communicators of Tendon. They do not depend on the environment.
/// Warnings of Ice are written to the log of Tendon at a limited rate.
Ice::InitializationData Settings();

/// Makes an adapter that accepts connections. Because its peers may be unauthenticated, messages
/// are limited to frames of kMaxPieceSize.
std::shared_ptr<Ice::ObjectAdapter> MakeListeningAdapter(Ice::Communicator& communicator,
                                                         const std::string& name,
                                                         const std::string& endpoints);

/// Joins the lines of a message of Ice into one line.
std::string OnOneLine(const std::string& text);

}  // namespace tendon::ice
