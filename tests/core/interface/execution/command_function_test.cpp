#include <gtest/gtest.h>

#include <functional>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "core/interface/arm_fixture.h"
#include "core/interface/waiting_fixture.h"
#include "support/allocation_guard.h"

namespace tendon_test {
namespace {

using tendon::kThreadSafe;
using tendon::Status;

double beeps = 0;
void Beep() noexcept { ++beeps; }
double Doubled(double value) { return 2 * value; }
double Scaled(const JointGoal& row, int factor) { return row.position[0] * factor; }

/// The methods of an author who has not read about Tendon.
struct Winch {
  void Stop() const noexcept { ++*stops; }
  void Wind(double metres) noexcept { length += metres; }
  double Length() const noexcept { return length; }
  JointGoal Pose() const { return {.position = {length}}; }
  const std::string& Label() const { return label; }
  double After(double metres) const { return length + metres; }
  std::shared_ptr<const std::string> Chart() const noexcept { return chart; }

  double width() const { return length; }
  void width(double value) { length = value; }

  std::unique_ptr<int> stops = std::make_unique<int>(0);
  double length = 1.0;
  std::string label = "winch";
  std::shared_ptr<const std::string> chart = std::make_shared<std::string>("reef");
};

struct WinchServer {
  tendon::Inbox inbox;
  tendon::StateTable table;
  JointGoal row;
  tendon::ProvidedInterface control{"Control", &inbox};
  tendon::WriteEvent<double> wound;
  tendon::VoidEvent jammed;
  Winch winch;
  int calls = 0;

  WinchServer() {
    table.Add(row, "Row");
    control.AddEvent(wound, "Wound");
    control.AddEvent(jammed, "Jammed");
    inbox.SetAccepting(true);
  }
};

struct WinchClient {
  tendon::Inbox inbox;
  tendon::RequiredInterface winch{"Winch", &inbox};

  WinchClient() { inbox.SetAccepting(true); }
};

/// Connects a client with one function to a server with one command of the same name.
template <typename Function>
struct WinchCall {
  template <typename Add>
  explicit WinchCall(Add add) {
    add(server);
    client.winch.AddFunction(function, "Call");
    connection = ConnectionOf(client.winch, server.control);
  }
  WinchServer server;
  WinchClient client;
  Function function;
  std::unique_ptr<tendon::Connection> connection;
};

/// Runs `call` in another thread while this thread serves it.
template <typename Call>
Status WhileServed(tendon::Inbox& inbox, Call call) {
  std::future<Status> waiting = std::async(std::launch::async, call);
  while (waiting.wait_for(0s) != std::future_status::ready) inbox.ExecuteQueued();
  return waiting.get();
}

TEST(CommandFunction, AVoidCommandTakesALambdaAFreeFunctionOrAConstNoexceptMethod) {
  WinchCall<tendon::VoidFunction> lambda([](WinchServer& server) {
    server.control.AddCommandVoid([&server] { ++server.calls; }, "Call");
  });
  WinchCall<tendon::VoidFunction> free_function(
      [](WinchServer& server) { server.control.AddCommandVoid(&Beep, "Call"); });
  WinchCall<tendon::VoidFunction> method([](WinchServer& server) {
    server.control.AddCommandVoid(&Winch::Stop, &server.winch, "Call");
  });
  beeps = 0;

  for (auto* call : {&lambda, &free_function, &method}) {
    EXPECT_EQ(call->function(), Status::kQueued);
    call->server.inbox.ExecuteQueued();
  }

  EXPECT_EQ(lambda.server.calls, 1);
  EXPECT_EQ(beeps, 1);
  EXPECT_EQ(*method.server.winch.stops, 1);
}

TEST(CommandFunction, AWriteCommandTakesALambdaOrANoexceptMethod) {
  WinchCall<tendon::WriteFunction<double>> lambda([](WinchServer& server) {
    server.control.AddCommandWrite([&server](double by) { server.winch.Wind(by); }, "Call");
  });
  WinchCall<tendon::WriteFunction<double>> method([](WinchServer& server) {
    server.control.AddCommandWrite(&Winch::Wind, &server.winch, "Call");
  });

  for (auto* call : {&lambda, &method}) {
    EXPECT_EQ(call->function(0.5), Status::kQueued);
    call->server.inbox.ExecuteQueued();
    EXPECT_EQ(call->server.winch.length, 1.5);
  }
}

TEST(CommandFunction, AReadCommandReturnsItsResultByValue) {
  WinchCall<tendon::ReadFunction<JointGoal>> method([](WinchServer& server) {
    server.control.AddCommandRead(&Winch::Pose, &server.winch, "Call", kThreadSafe);
  });
  WinchCall<tendon::ReadFunction<std::string>> reference([](WinchServer& server) {
    server.control.AddCommandRead(&Winch::Label, &server.winch, "Call", kThreadSafe);
  });
  WinchCall<tendon::ReadFunction<double>> lambda([](WinchServer& server) {
    server.control.AddCommandRead([&server](double& out) { out = server.winch.Length(); }, "Call",
                                  kThreadSafe);
  });
  JointGoal pose;
  std::string label;
  double length = 0;

  EXPECT_EQ(method.function(pose), Status::kDone);
  EXPECT_EQ(reference.function(label), Status::kDone);
  EXPECT_EQ(lambda.function(length), Status::kDone);

  EXPECT_EQ(pose, (JointGoal{.position = {1.0}}));
  EXPECT_EQ(label, "winch");
  EXPECT_EQ(length, 1.0);
}

TEST(CommandFunction, AReadCommandSharesTheValueOfALambdaToo) {
  WinchCall<tendon::ReadFunction<std::string>> method([](WinchServer& server) {
    server.control.AddCommandRead(&Winch::Chart, &server.winch, "Call", kThreadSafe);
  });
  WinchCall<tendon::ReadFunction<std::string>> lambda([](WinchServer& server) {
    server.control.AddCommandRead([&server] { return server.winch.Chart(); }, "Call", kThreadSafe);
  });

  for (auto* call : {&method, &lambda}) {
    std::string chart;
    EXPECT_EQ(call->function(chart), Status::kDone);
    EXPECT_EQ(chart, "reef");
    call->server.winch.chart = nullptr;
    EXPECT_EQ(call->function(chart), Status::kNoSample);
  }
}

TEST(CommandFunction, AQualifiedReadTakesAFunctionThatReturnsItsResult) {
  using Ask = tendon::QualifiedReadFunction<double, double>;
  WinchCall<Ask> method([](WinchServer& server) {
    server.control.AddCommandQualifiedRead(&Winch::After, &server.winch, "Call", kThreadSafe);
  });
  WinchCall<Ask> free_function([](WinchServer& server) {
    server.control.AddCommandQualifiedRead(&Doubled, "Call", kThreadSafe);
  });
  double result = 0;

  EXPECT_EQ(method.function(0.5, result), Status::kDone);
  EXPECT_EQ(result, 1.5);
  EXPECT_EQ(free_function.function(0.5, result), Status::kDone);
  EXPECT_EQ(result, 1.0);
}

TEST(CommandFunction, AQualifiedReadOfATableTakesAFunctionThatReturnsItsResult) {
  using Ask = tendon::QualifiedReadFunction<int, double>;
  WinchCall<Ask> free_function([](WinchServer& server) {
    server.control.AddCommandQualifiedRead(server.table, server.row, &Scaled, "Call");
  });
  WinchCall<Ask> lambda([](WinchServer& server) {
    server.control.AddCommandQualifiedRead(
        server.table, server.row,
        [](const JointGoal& row, int factor, double& out) { out = row.position[0] * factor; },
        "Call");
  });

  for (auto* call : {&free_function, &lambda}) {
    double result = 0;
    EXPECT_EQ(call->function(3, result), Status::kNoSample);
    call->server.row.position[0] = 2.0;
    call->server.table.Advance(tendon::SteadyClock().Now());
    EXPECT_EQ(call->function(3, result), Status::kDone);
    EXPECT_EQ(result, 6.0);
  }
}

TEST(CommandFunction, CommandsThatReturnAResultTakeFunctionsThatReturnIt) {
  WinchCall<tendon::VoidReturnFunction<double>> get([](WinchServer& server) {
    server.control.AddCommandVoidReturn(&Winch::Length, &server.winch, "Call");
  });
  WinchCall<tendon::WriteReturnFunction<double, double>> ask([](WinchServer& server) {
    server.control.AddCommandWriteReturn([](double value) { return -value; }, "Call");
  });
  double result = 0;

  EXPECT_EQ(WhileServed(get.server.inbox, [&] { return get.function.Wait(result, 5s); }),
            Status::kDone);
  EXPECT_EQ(result, 1.0);
  EXPECT_EQ(WhileServed(ask.server.inbox, [&] { return ask.function.Wait(2.0, result, 5s); }),
            Status::kDone);
  EXPECT_EQ(result, -2.0);
}

TEST(CommandFunction, ANullFunctionIsRefusedWhenItIsAdded) {
  WinchServer server;
  void (*const null)() = nullptr;

  EXPECT_THROW(server.control.AddCommandVoid(null, "Null"), tendon::ConfigurationError);
  EXPECT_THROW(server.control.AddCommandVoid(std::function<void()>(), "Empty"),
               tendon::ConfigurationError);
}

TEST(CommandFunction, AFilterAndItsCommandCanBeLambdas) {
  WinchCall<tendon::WriteFunction<int>> call([](WinchServer& server) {
    server.control.AddCommandFilteredWrite([](int cm) { return cm / 100.0; },
                                           [&server](double by) { server.winch.Wind(by); }, "Call");
  });

  EXPECT_EQ(call.function(50), Status::kQueued);
  call.server.inbox.ExecuteQueued();

  EXPECT_EQ(call.server.winch.length, 1.5);
}

TEST(CommandFunction, ConnectionsShareTheStateOfALambda) {
  WinchServer server;
  std::vector<int> counts;
  server.control.AddCommandVoid(
      [&counts, owned = std::make_unique<int>(0)]() mutable { counts.push_back(++*owned); },
      "Call");
  WinchClient clients[2];
  tendon::VoidFunction calls[2];
  std::vector<std::unique_ptr<tendon::Connection>> connections;
  for (int i = 0; i < 2; ++i) {
    clients[i].winch.AddFunction(calls[i], "Call");
    connections.push_back(ConnectionOf(clients[i].winch, server.control));
  }

  EXPECT_EQ(calls[0](), Status::kQueued);
  EXPECT_EQ(calls[1](), Status::kQueued);
  server.inbox.ExecuteQueued();

  EXPECT_EQ(counts, (std::vector<int>{1, 2}));
}

TEST(CommandFunction, OneOfTwoMethodsWithTheSameNameIsSelectedByTheKindOfTheCommand) {
  WinchCall<tendon::WriteFunction<double>> call([](WinchServer& server) {
    server.control.AddCommandWrite(&Winch::width, &server.winch, "Call");
  });

  EXPECT_EQ(call.function(4.0), Status::kQueued);
  call.server.inbox.ExecuteQueued();

  EXPECT_EQ(call.server.winch.length, 4.0);
}

TEST(CommandFunction, EventHandlersTakeLambdasAndConstMethods) {
  WinchServer server;
  WinchClient client;
  Winch other;
  double queued = 0;
  double direct = 0;
  client.winch.AddEventHandlerWrite([&queued](double metres) { queued = metres; }, "Wound");
  client.winch.AddEventHandlerVoid(&Winch::Stop, &other, "Jammed", kThreadSafe);
  WinchClient second;
  second.winch.AddEventHandlerWrite([&direct](const double& metres) { direct = metres; }, "Wound",
                                    kThreadSafe, tendon::Need::kOptional);
  second.winch.AddEventHandlerVoid(&Beep, "Jammed", tendon::Need::kOptional);
  const auto connection = ConnectionOf(client.winch, server.control);
  const auto connection2 = ConnectionOf(second.winch, server.control);
  beeps = 0;

  server.wound(2.5);
  server.jammed();

  EXPECT_EQ(queued, 0);
  EXPECT_EQ(direct, 2.5);
  EXPECT_EQ(*other.stops, 1);
  client.inbox.ExecuteQueued();
  second.inbox.ExecuteQueued();
  EXPECT_EQ(queued, 2.5);
  EXPECT_EQ(beeps, 1);
}

TEST(CommandFunction, CallsOfLambdasAllocateNothing) {
  WinchCall<tendon::WriteFunction<JointGoal>> write([](WinchServer& server) {
    server.control.AddCommandWrite(
        [&server, owned = std::make_unique<int>(0)](const JointGoal& goal) {
          server.winch.length = goal.position[0];
          ++*owned;
        },
        "Call");
  });
  WinchCall<tendon::ReadFunction<JointGoal>> read([](WinchServer& server) {
    server.control.AddCommandRead(&Winch::Pose, &server.winch, "Call", kThreadSafe);
  });
  JointGoal pose;

  const tendon::AllocationGuard guard;
  EXPECT_EQ(write.function({.position = {3.0}}), Status::kQueued);
  write.server.inbox.ExecuteQueued();
  EXPECT_EQ(read.function(pose), Status::kDone);

  EXPECT_EQ(write.server.winch.length, 3.0);
}

TEST(CommandFunction, ABoundMethodIsAsLargeAsItsPointers) {
  using Bound = tendon::callable::BoundMethod<void (Winch::*)(double) noexcept, Winch>;

  static_assert(sizeof(tendon::callable::Handler<Bound>) == sizeof(Bound));
  static_assert(std::is_trivially_copyable_v<tendon::callable::Handler<Bound>>);
}

TEST(Expiry, EndsWithALambda) {
  WinchServer server;
  auto& offer = server.control.AddCommandVoid([] {}, "Call");

  EXPECT_EQ(&offer.ExpiresAfter(50ms, [&server] { ++server.calls; }), &offer);
  EXPECT_NE(offer.expiry(), nullptr);
}

}  // namespace
}  // namespace tendon_test
