#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/manager/local_manager.h>
#include <tendon/task/periodic_task.h>

#include <atomic>
#include <stdexcept>

#include "support/wait.h"

namespace {

using tendon::ComponentState;
using tendon::StateTable;
using tendon::Status;
using testing::HasSubstr;
using namespace std::chrono_literals;

/// Counts its cycles; does what the test tells it.
class Counting final : public tendon::PeriodicTask {
 public:
  explicit Counting(std::string name, std::chrono::nanoseconds period = 1ms)
      : PeriodicTask(std::move(name), period) {
    state_table().Add(count_, "Count");
    auto& control = AddProvidedInterface("Control");
    control.AddCommandVoid(&Counting::Fail, this, "Fail");
    control.AddCommandReadState(state_table(), count_, "GetCount");
  }
  std::atomic<int> startups = 0;
  std::atomic<int> cleanups = 0;
  std::atomic<bool> configure_fails = false;

  const StateTable& table() const { return *tables().front(); }

 private:
  void Configure() override {
    if (configure_fails) throw std::runtime_error("no hardware");
  }
  void Startup() override { ++startups; }
  void Cleanup() override { ++cleanups; }
  void Run() override {
    ProcessQueuedCommands();
    ++count_;
  }
  void Fail() { throw std::runtime_error("cable cut"); }

  std::uint64_t count_ = 0;
};

/// A client of Counting without a thread.
class Client final : public tendon::Component {
 public:
  explicit Client(std::string name) : Component(std::move(name)) {
    auto& server = AddRequiredInterface("Server");
    server.AddFunction(fail, "Fail");
    server.AddFunction(get_count, "GetCount");
  }
  tendon::VoidFunction fail;
  tendon::ReadFunction<std::uint64_t> get_count;
};

TEST(PeriodicTask, RunsCyclesAndPublishesEachAsARow) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Counting>("counting");

  ASSERT_TRUE(manager.StartAll().ok());
  EXPECT_EQ(task.state(), ComponentState::kActive);
  ASSERT_TRUE(EventuallyTrue([&] { return task.table().next_tick() >= 20; }));
  ASSERT_TRUE(manager.StopAll().ok());

  EXPECT_EQ(task.state(), ComponentState::kFinished);
  EXPECT_EQ(task.startups, 1);
  EXPECT_EQ(task.cleanups, 1);
}

TEST(PeriodicTask, StaysOnItsGrid) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Counting>("counting");
  ASSERT_TRUE(manager.StartAll().ok());
  ASSERT_TRUE(EventuallyTrue([&] { return task.table().next_tick() >= 200; }));
  ASSERT_TRUE(manager.StopAll().ok());

  // A row's time, less how late it was, is a point on the grid; overruns say which.
  const auto& table = task.table();
  const auto point_of = [&table](std::uint64_t tick) {
    std::vector<std::uint64_t> row(table.row_words());
    std::int64_t time = 0;
    EXPECT_EQ(table.CopyRow(tick, row, time), tendon::RowResult::kDone);
    tendon::CycleStatistics cycle;
    EXPECT_TRUE(tendon::Decode(table.cell(row, 0), cycle));
    const double due = static_cast<double>(time) - cycle.lateness * 1e9;
    return due - static_cast<double>(tick + cycle.overruns) * 1e6;
  };
  for (std::uint64_t tick = 1; tick < 200; ++tick) {
    EXPECT_NEAR(point_of(tick), point_of(0), 10.0) << "row " << tick;
  }
}

TEST(PeriodicTask, AnExceptionInACommandFaultsItAndARestartHeals) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Counting>("counting");
  auto& bystander = manager.Add<Counting>("bystander");
  auto& client = manager.Add<Client>("client");
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"counting", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());

  EXPECT_EQ(client.fail(), Status::kQueued);
  ASSERT_TRUE(EventuallyTrue([&] { return task.state() == ComponentState::kFaulted; }));

  EXPECT_EQ(task.fault(), "Run: cable cut");
  EXPECT_EQ(client.fail(), Status::kNotActive);
  EXPECT_EQ(bystander.state(), ComponentState::kActive);
  ASSERT_TRUE(manager.Start("counting").ok());
  EXPECT_EQ(task.state(), ComponentState::kActive);
  EXPECT_EQ(task.fault(), "");
  EXPECT_EQ(client.fail(), Status::kQueued);
}

TEST(PeriodicTask, WhatWaitedWhenItEndedIsNotExecutedAtTheNextStart) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Counting>("counting");
  auto& client = manager.Add<Client>("client");
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"counting", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());
  EXPECT_EQ(client.fail(), Status::kQueued);
  EXPECT_EQ(client.fail(), Status::kQueued);  // still waits when the first has faulted the task
  ASSERT_TRUE(EventuallyTrue([&] { return task.state() == ComponentState::kFaulted; }));

  ASSERT_TRUE(manager.Start("counting").ok());
  const std::uint64_t before = task.table().next_tick();
  ASSERT_TRUE(EventuallyTrue([&] { return task.table().next_tick() >= before + 5; }));

  EXPECT_EQ(task.state(), ComponentState::kActive);
}

TEST(PeriodicTask, AFailureInConfigureIsTheAnswerOfStart) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Counting>("counting");
  task.configure_fails = true;

  const auto started = manager.Start("counting");

  ASSERT_FALSE(started.ok());
  EXPECT_THAT(started.error().message, HasSubstr("Configure: no hardware"));
  EXPECT_EQ(task.state(), ComponentState::kFaulted);
}

TEST(PeriodicTask, IllegalTransitionsAreRefused) {
  tendon::LocalManager manager;
  manager.Add<Counting>("counting");

  EXPECT_FALSE(manager.Stop("counting").ok());
  ASSERT_TRUE(manager.Start("counting").ok());
  EXPECT_FALSE(manager.Start("counting").ok());
  ASSERT_TRUE(manager.Stop("counting").ok());
  EXPECT_FALSE(manager.Stop("counting").ok());
  EXPECT_TRUE(manager.Start("counting").ok());
}

TEST(PeriodicTask, APeriodOutOfRangeIsRefused) {
  tendon::LocalManager manager;

  EXPECT_THROW(manager.Add<Counting>("a", 0ns), tendon::ConfigurationError);
  EXPECT_THROW(manager.Add<Counting>("b", -1ms), tendon::ConfigurationError);
  EXPECT_THROW(manager.Add<Counting>("c", 1ns), tendon::ConfigurationError);
  EXPECT_THROW(manager.Add<Counting>("d", 2h), tendon::ConfigurationError);
}

TEST(PeriodicTask, ASlowOneStopsSoon) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Counting>("slow", 1h);
  ASSERT_TRUE(manager.StartAll().ok());

  ASSERT_TRUE(manager.StopAll().ok());

  EXPECT_EQ(task.state(), ComponentState::kFinished);
}

TEST(Task, ItsTableIsAnInterfaceWithAReadForEachColumn) {
  class Viewer final : public tendon::Component {
   public:
    explicit Viewer(std::string name) : Component(std::move(name)) {
      auto& state = AddRequiredInterface("State");
      state.AddFunction(count, "Count");
      state.AddFunction(cycle, "Cycle");
    }
    tendon::ReadFunction<std::uint64_t> count;
    tendon::ReadFunction<tendon::CycleStatistics> cycle;
  };
  tendon::LocalManager manager;
  manager.Add<Counting>("counting");
  auto& viewer = manager.Add<Viewer>("viewer");
  const auto connected = manager.Connect({"viewer", "State"}, {"counting", "state"});
  ASSERT_TRUE(connected.ok()) << connected.error().message;
  std::uint64_t count = 0;
  EXPECT_EQ(viewer.count(count), Status::kNoSample);

  ASSERT_TRUE(manager.StartAll().ok());

  EXPECT_TRUE(EventuallyTrue([&] { return viewer.count(count) && count >= 3; }));
  tendon::CycleStatistics cycle;
  EXPECT_EQ(viewer.cycle(cycle), Status::kDone);
}

TEST(Component, NamesOfInterfacesAreChecked) {
  class Named final : public tendon::Component {
   public:
    Named(std::string name, std::string interface) : Component(std::move(name)) {
      AddProvidedInterface(std::move(interface));
      AddProvidedInterface("Other");
    }
  };
  EXPECT_NO_THROW(Named("arm", "Control"));
  EXPECT_THROW(Named("arm", "Other"), tendon::ConfigurationError);
  EXPECT_THROW(Named("arm", "state"), tendon::ConfigurationError);
  EXPECT_THROW(Named("arm", "state-x"), tendon::ConfigurationError);
  EXPECT_THROW(Named("arm", "a b"), tendon::ConfigurationError);
  EXPECT_THROW(Named("", "Control"), tendon::ConfigurationError);
}

TEST(Component, NothingCanBeAddedToARunningOne) {
  class Late final : public tendon::Component {
   public:
    explicit Late(std::string name) : Component(std::move(name)) {}
    void AddNow() { AddProvidedInterface("Late"); }
  };
  tendon::LocalManager manager;
  auto& late = manager.Add<Late>("late");
  ASSERT_TRUE(manager.StartAll().ok());

  try {
    late.AddNow();
    FAIL() << "nothing was thrown";
  } catch (const tendon::ConfigurationError& error) {
    EXPECT_THAT(error.what(), HasSubstr("component 'late' (state active)"));
  }
}

}  // namespace
