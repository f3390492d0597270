#include <benchmarks/remote/rivals/rival.h>
#include <zmq.h>

#include <array>
#include <stdexcept>
#include <thread>

namespace tendon::benchmark {
namespace {

constexpr int kTestTimeout = 10'000;  // ms

/// The ZeroMQ context of one end. Its end also ends the waits in its sockets.
class Context {
 public:
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() { zmq_ctx_term(context_); }

  void ShutDown() { zmq_ctx_shutdown(context_); }
  [[nodiscard]] void* NewSocket(int type) const { return zmq_socket(context_, type); }

 private:
  void* const context_ = zmq_ctx_new();
};

class Socket {
 public:
  Socket(const Context& context, int type) : socket_(context.NewSocket(type)) {}
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  ~Socket() { zmq_close(socket_); }

  [[nodiscard]] void* get() const { return socket_; }

 private:
  void* const socket_;
};

void Require(bool done) {
  if (!done) throw std::runtime_error(std::string("ZeroMQ: ") + zmq_strerror(zmq_errno()));
}

class Server final : public RivalServer {
 public:
  Server() { Require(zmq_bind(socket_.get(), "tcp://127.0.0.1:*") == 0); }
  ~Server() override { context_.ShutDown(); }

  [[nodiscard]] std::string address() const override {
    std::array<char, 256> text{};
    std::size_t size = text.size();
    Require(zmq_getsockopt(socket_.get(), ZMQ_LAST_ENDPOINT, text.data(), &size) == 0);
    return text.data();
  }

 private:
  void Serve() {
    const Message reply{};
    char question = 0;
    while (zmq_recv(socket_.get(), &question, 1, 0) >= 0) {
      zmq_send(socket_.get(), reply.data(), sizeof(reply), 0);
    }
  }

  Context context_;
  Socket socket_{context_, ZMQ_REP};
  std::jthread thread_{[this] { Serve(); }};
};

class Client final : public RivalClient {
 public:
  explicit Client(const std::string& address) {
    Require(zmq_setsockopt(socket_.get(), ZMQ_RCVTIMEO, &kTestTimeout, sizeof(kTestTimeout)) == 0);
    Require(zmq_connect(socket_.get(), address.c_str()) == 0);
    Message reply{};
    Read(reply);
  }

  void Read(Message& reply) override {
    Require(zmq_send(socket_.get(), "?", 1, 0) == 1);
    Require(zmq_recv(socket_.get(), reply.data(), sizeof(reply), 0) == sizeof(reply));
  }

 private:
  Context context_;
  Socket socket_{context_, ZMQ_REQ};
};

}  // namespace

Rival ZeroMq() {
  return {.id = "R8-zmq",
          .name = "ZeroMQ",
          .stretch = 0.75,
          .missing = {},
          .serve = [] { return std::make_unique<Server>(); },
          .reach = [](const std::string& address) { return std::make_unique<Client>(address); }};
}

}  // namespace tendon::benchmark
