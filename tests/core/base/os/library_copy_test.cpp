#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <tendon/base/os/file.h>
#include <tendon/base/os/library_copy.h>

#include <cstdlib>
#include <filesystem>

#include "support/folder.h"

namespace tendon::os {
namespace {

namespace fs = std::filesystem;

TEST(LibraryCopy, RemovesAllUnlockedFolders) {
  const test::Folder runtime;
  fs::permissions(runtime.path(), fs::perms::owner_all);
  setenv("XDG_RUNTIME_DIR", runtime.path().c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
  const fs::path plugins = runtime.path() / "tendon" / "plugins";
  // The folder of a process in another container.
  const fs::path of_living = plugins / "999999999-1";
  const fs::path left_behind = plugins / "1-1";
  fs::create_directories(of_living / "1");
  fs::create_directories(left_behind / "1");
  for (const fs::path& folder : {runtime.path() / "tendon", plugins}) {
    fs::permissions(folder, fs::perms::owner_all);
  }
  const Descriptor lock(open(of_living.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  ASSERT_EQ(flock(lock.get(), LOCK_EX | LOCK_NB), 0);
  runtime.Write("arm.so", "text");

  const auto copy = LibraryCopy::Make(runtime.path() / "arm.so");

  ASSERT_TRUE(copy) << copy.error().message;
  EXPECT_EQ((*copy)->path().filename(), "arm.so");
  const fs::path own = (*copy)->path().parent_path().parent_path();
  ASSERT_EQ(own.parent_path(), plugins);
  EXPECT_TRUE(fs::exists(of_living / "1"));
  EXPECT_FALSE(fs::exists(left_behind));
  const Descriptor other(open(own.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  EXPECT_NE(flock(other.get(), LOCK_EX | LOCK_NB), 0) << "ours is locked";
}

}  // namespace
}  // namespace tendon::os
