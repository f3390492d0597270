#include <sys/wait.h>
#include <tendon/base/os/process.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "conformance/contract.h"

namespace tendon::conformance {
namespace {

/// A conformance_peer that runs as another process.
class Peer {
 public:
  explicit Peer(std::vector<std::string> words) {
    words.insert(words.begin(), os::ProgramFolder() / "conformance_peer");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::array<int, 2> input{};
    std::array<int, 2> output{};
    if (pipe(input.data()) != 0 || pipe(output.data()) != 0) return;
    pid_ = fork();
    if (pid_ == 0) {
      dup2(input[0], STDIN_FILENO);
      dup2(output[1], STDOUT_FILENO);
      for (const int descriptor : {input[0], input[1], output[0], output[1]}) close(descriptor);
      execv(arguments[0], arguments.data());
      _exit(EXIT_FAILURE);
    }
    close(input[0]);
    close(output[1]);
    input_ = input[1];
    output_ = output[0];
  }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  ~Peer() {
    Kill();
    close(input_);
    close(output_);
  }

  std::string ReadLine() {
    std::string line;
    for (char c = 0; read(output_, &c, 1) == 1 && c != '\n';) line += c;
    return line;
  }

  void Kill() {
    if (pid_ <= 0) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    pid_ = -1;
  }

 private:
  pid_t pid_ = -1;
  int input_ = -1;
  int output_ = -1;
};

TEST_P(PortContract, TheOpenerIsNotifiedOnceOfAKilledAcceptor) {
  pair_ = GetParam().make(Exposure::kLoopbackOnly);
  Peer peer({GetParam().name, "listen"});
  const std::string address = peer.ReadLine();
  const auto recorder = std::make_shared<Recorder>();
  const auto link = pair_.client->Open(address, recorder, kTestTimeout);
  ASSERT_TRUE(link) << link.error().message;

  peer.Kill();

  ASSERT_TRUE(recorder->WaitForClosed());
  EXPECT_EQ(recorder->reason().code, ErrorCode::kUnreachable);
  EXPECT_EQ((*link)->Send(FrameOf(1)), Status::kNotConnected);
  pair_ = {};
  EXPECT_EQ(recorder->closed(), 1);
}

TEST_P(PortContract, TheAcceptorIsNotifiedOnceOfAKilledOpener) {
  Host host;
  Start(host.accept());
  Peer peer({GetParam().name, "open", listener_->address()});
  ASSERT_EQ(peer.ReadLine(), "open");
  const auto guest = host.guest();
  ASSERT_NE(guest.link, nullptr);
  ASSERT_TRUE(guest.recorder->WaitForFrames(1));

  peer.Kill();

  ASSERT_TRUE(guest.recorder->WaitForClosed());
  EXPECT_EQ(guest.recorder->reason().code, ErrorCode::kUnreachable);
  EXPECT_TRUE(Open(std::make_shared<Recorder>()));
  listener_.reset();
  EXPECT_EQ(guest.recorder->closed(), 1);
}

}  // namespace
}  // namespace tendon::conformance
