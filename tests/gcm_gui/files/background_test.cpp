#include <gcm_gui/files/background.h>
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <memory>
#include <string>
#include <thread>

namespace tendon::gui {
namespace {

constexpr std::chrono::milliseconds kAMoment{20};
constexpr std::chrono::minutes kLongForBackground{1};

TEST(Background, TheDestructorWaitsForStartedTasks) {
  std::string done;
  {
    Background background("a test");
    background.start([&] { done += 'a'; });
    background.start([&] { done += 'b'; });
  }

  EXPECT_EQ(done, "ab");
}

TEST(Background, TheDestructorTimesOutWithAWarning) {
  const auto go = std::make_shared<std::promise<void>>();
  const auto end = std::make_shared<std::promise<void>>();
  std::promise<void> begun;
  testing::internal::CaptureStderr();
  {
    Background background("a test", kAMoment);
    background.start([&begun, go, end] {
      begun.set_value();
      go->get_future().wait();
      end->set_value();
    });
    begun.get_future().wait();
  }
  const std::string said = testing::internal::GetCapturedStderr();

  EXPECT_EQ(said, "gcm-gui: a test was not finished: it took longer than 20 ms\n");
  go->set_value();  // lets the task continue
  EXPECT_EQ(end->get_future().wait_for(kLongForBackground), std::future_status::ready);
}

TEST(Background, DroppedTasksAreNotDone) {
  std::promise<void> begun;
  std::promise<void> go;
  std::string done;
  {
    Background background("a test");
    background.start([&] {
      begun.set_value();
      go.get_future().wait();
      done += 'a';
    });
    background.start([&] { done += 'b'; });
    begun.get_future().wait();
    background.dropWaiting();
    go.set_value();
  }

  EXPECT_EQ(done, "a");
}

TEST(Background, TasksThatAreHandedOverAreDoneWithoutTheirBackground) {
  const auto go = std::make_shared<std::promise<void>>();
  const auto end = std::make_shared<std::promise<void>>();
  std::promise<void> begun;
  testing::internal::CaptureStderr();
  {
    Background background("a test", kAMoment);
    background.start([&begun, go] {
      begun.set_value();
      go->get_future().wait();
    });
    background.start([end] { end->set_value(); });
    begun.get_future().wait();
    background.handOver();
  }
  const std::string said = testing::internal::GetCapturedStderr();

  EXPECT_EQ(said, "") << "the destructor waited";
  go->set_value();
  EXPECT_EQ(end->get_future().wait_for(kLongForBackground), std::future_status::ready);
}

TEST(Background, TheThreadReleasesTheBelongingsAfterTheLastTask) {
  const auto go = std::make_shared<std::promise<void>>();
  const auto released = std::make_shared<std::promise<std::thread::id>>();
  std::string done;
  {
    Background background("a test");
    background.start([&done, go] {
      go->get_future().wait();
      done += 'a';
    });
    background.handOver(std::shared_ptr<const void>(nullptr, [&done, released](const void*) {
      done += 'b';
      released->set_value(std::this_thread::get_id());
    }));
  }
  go->set_value();

  EXPECT_NE(released->get_future().get(), std::this_thread::get_id());
  EXPECT_EQ(done, "ab");
}

}  // namespace
}  // namespace tendon::gui
