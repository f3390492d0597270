// The other process of the tests that kill a process. `conformance_peer KIND listen` prints the
// address at which it listens. `conformance_peer KIND open ADDRESS` opens a link and prints "open".
// Both then wait for the end of their standard input.

#include <cstdlib>
#include <iostream>
#include <string>

#include "conformance/peer_kinds.h"
#include "conformance/recorder.h"

namespace {

using tendon::conformance::FrameOf;
using tendon::conformance::Host;
using tendon::conformance::kTestTimeout;
using tendon::conformance::Recorder;

int Run(const std::string& kind, const std::string& verb, const std::string& address) {
  const auto middleware = tendon::conformance::MiddlewareOf(kind);
  Host host;
  const auto recorder = std::make_shared<Recorder>();
  std::unique_ptr<tendon::Listener> listener;
  if (verb == "listen") {
    auto made = middleware->Listen("127.0.0.1:0", host.accept());
    if (!made) return EXIT_FAILURE;
    listener = *std::move(made);
    std::cout << listener->address() << std::endl;
  } else {
    const auto link = middleware->Open(address, recorder, kTestTimeout);
    if (!link || !(*link)->Send(FrameOf(1))) return EXIT_FAILURE;
    std::cout << "open" << std::endl;
  }
  std::cin.get();
  return EXIT_SUCCESS;
}

}  // namespace

int main(int count, char** words) {
  if (count < 3) return EXIT_FAILURE;
  return Run(words[1], words[2], count > 3 ? words[3] : "");
}
