// fault_lossy_proxy LISTEN TARGET: passes on the bytes of TCP connections like a bad line. Every
// piece is 40 ms late in each direction. One piece in twenty is later by the time of a TCP
// retransmission.
#include <fcntl.h>
#include <sys/socket.h>
#include <tendon/base/os/socket.h>
#include <tendon/middleware/middleware.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <deque>
#include <memory>
#include <mutex>
#include <random>
#include <thread>
#include <utility>
#include <vector>

namespace {

using namespace std::chrono_literals;
using tendon::Bytes;
using tendon::os::Socket;
using Time = std::chrono::steady_clock::time_point;

/// One direction of one connection. An empty piece means the end.
class Line {
 public:
  Line(std::shared_ptr<Socket> from, std::shared_ptr<Socket> to)
      : from_(std::move(from)), to_(std::move(to)) {}

  void Read() {
    std::mt19937 random(4711);
    Bytes buffer(4096);
    Time due{};
    for (std::size_t size = 1; size > 0;) {
      const ssize_t received = recv(from_->descriptor(), buffer.data(), buffer.size(), 0);
      size = received > 0 ? static_cast<std::size_t>(received) : 0;
      const bool is_lost = random() % 20 == 0;
      due = std::max(due, std::chrono::steady_clock::now() + 40ms + (is_lost ? 200ms : 0ms));
      const std::scoped_lock lock(mutex_);
      pieces_.push_back({due, Bytes(buffer.begin(), buffer.begin() + received * (received > 0))});
      changed_.notify_one();
    }
  }

  void Write() {
    while (true) {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return !pieces_.empty(); });
      const Piece piece = std::move(pieces_.front());
      pieces_.pop_front();
      lock.unlock();
      std::this_thread::sleep_until(piece.due);
      const bool is_sent = send(to_->descriptor(), piece.bytes.data(), piece.bytes.size(),
                                MSG_NOSIGNAL) == static_cast<ssize_t>(piece.bytes.size());
      if (piece.bytes.empty() || !is_sent) break;
    }
    shutdown(to_->descriptor(), SHUT_WR);
    shutdown(from_->descriptor(), SHUT_RD);
  }

 private:
  struct Piece {
    Time due;
    Bytes bytes;
  };
  const std::shared_ptr<Socket> from_;
  const std::shared_ptr<Socket> to_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Piece> pieces_;
};

std::shared_ptr<Socket> Blocking(Socket socket) {
  const int flags = fcntl(socket.descriptor(), F_GETFL);
  fcntl(socket.descriptor(), F_SETFL, flags & ~O_NONBLOCK);
  return std::make_shared<Socket>(std::move(socket));
}

void Pass(const std::shared_ptr<Socket>& from, const std::shared_ptr<Socket>& to) {
  const auto line = std::make_shared<Line>(from, to);
  std::thread([line] { line->Read(); }).detach();
  std::thread([line] { line->Write(); }).detach();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto here = tendon::ParseAddress(argv[1], 1);
  const auto target = tendon::ParseAddress(argv[2], 1);
  if (!here || !target) return 2;
  const auto listening = tendon::os::ListenAt(here->host, here->port);
  if (!listening) {
    std::fprintf(stderr, "%s\n", listening.error().message.c_str());
    return 1;
  }
  std::puts("ready");
  std::fflush(stdout);
  while (true) {
    Socket accepted;
    if (tendon::os::Accept(*listening, accepted) != tendon::os::AcceptResult::kOne) {
      std::this_thread::sleep_for(5ms);
      continue;
    }
    auto connected = tendon::os::ConnectTo(target->host, target->port, 5s);
    if (!connected) continue;
    const auto client = Blocking(std::move(accepted));
    const auto server = Blocking(*std::move(connected));
    Pass(client, server);
    Pass(server, client);
  }
}
