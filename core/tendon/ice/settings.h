#pragma once

#include <Ice/Ice.h>

#include <memory>
#include <string>

namespace tendon::ice {

/// The settings of all our communicators, independent of the environment. Ice's warnings go to our
/// log, at a limited rate.
Ice::InitializationData Settings();

/// An adapter that accepts unauthenticated peers: its messages are limited to kMaxPieceSize.
std::shared_ptr<Ice::ObjectAdapter> MakeListeningAdapter(Ice::Communicator& communicator,
                                                         const std::string& name,
                                                         const std::string& endpoints);

/// Puts a message of Ice, which has several lines, on one line.
std::string OnOneLine(const std::string& text);

}  // namespace tendon::ice
