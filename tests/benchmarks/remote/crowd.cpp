// One of the processes of a large system: crowd NAME GCM COMPONENTS. Prepares its components, each
// with ten interfaces of ten commands. Then it stops itself. When it is continued, it joins the
// GCM. Runs until it is killed.

#include <tendon/base/log.h>
#include <tendon/ice/ice_middleware.h>
#include <tendon/process/process.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <utility>

namespace {

constexpr int kInterfaces = 10;
constexpr int kCommands = 10;  // commands per interface

class Member final : public tendon::Component {
 public:
  explicit Member(std::string name) : Component(std::move(name)) {
    for (int i = 0; i < kInterfaces; ++i) {
      auto& interface = AddProvidedInterface("Interface" + std::to_string(i));
      for (int j = 0; j < kCommands; ++j) {
        interface.AddCommandWrite(&Member::Take, this, "Command" + std::to_string(j));
      }
    }
  }

 private:
  void Take(const double& value) { value_ = value; }

  double value_ = 0;
};

}  // namespace

int main(int /*count*/, char** words) {
  using namespace tendon;
  auto middleware = MakeIceMiddleware(Exposure::kLoopbackOnly);
  SetLogLevel(LogLevel::kWarning);
  raise(SIGSTOP);
  Process process(words[1], {.middleware = std::move(middleware), .gcm = words[2]});
  for (int i = 0; i < std::stoi(words[3]); ++i) process.Add<Member>("member" + std::to_string(i));
  while (true) pause();
}
