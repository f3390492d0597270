#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/manager/component_loader.h>
#include <tendon/manager/plugin.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "support/folder.h"

/// Every broken plug-in gives one sentence, and leaves nothing loaded.
namespace tendon {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::MatchesRegex;

const fs::path kBuilt = TENDON_TEST_PLUGINS;

std::string Content(const fs::path& file) {
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  return content.str();
}

/// Returns true if this process has mapped the file, or a copy of it.
bool IsMapped(const fs::path& file) {
  return Content("/proc/self/maps").find("/" + file.filename().string()) != std::string::npos;
}

/// Writes files that the loader examines. The name of the file is `library`.
struct PluginTest : testing::Test {
  fs::path Write(const std::string& name, const std::string& content) const {
    const fs::path file = folder / (name + ".so");
    std::ofstream(file, std::ios::binary) << content;
    return file;
  }
  /// Returns the loader's message about a plug-in, without "plug-in PATH: ".
  std::string Refusal(const std::string& library, const fs::path& in = kBuilt) {
    ComponentLoader loader({in, folder});
    const fs::path file = in / (library + ".so");
    const auto loaded = loader.Load(library);
    if (loaded) return "loaded";
    EXPECT_FALSE(IsMapped(file));
    EXPECT_TRUE(loader.loaded().empty());
    EXPECT_EQ(loaded.error().message.find('\n'), std::string::npos);
    const std::string start = "plug-in " + file.string() + ": ";
    EXPECT_EQ(loaded.error().message.substr(0, start.size()), start);
    return loaded.error().message.substr(start.size());
  }
  /// Does the same for a good plug-in in which some bytes are replaced.
  std::string RefusalOfPatched(std::size_t offset, const std::string& bytes) {
    std::string content = Content(kBuilt / "good.so");
    content.replace(offset, bytes.size(), bytes);
    Write("patched", content);
    return Refusal("patched", folder);
  }

  const test::Folder temporary;
  const fs::path folder = temporary.path();
};

TEST_F(PluginTest, AValidPlugInRegistersItsClasses) {
  ComponentLoader loader({kBuilt});

  const auto loaded = loader.Load("good");

  ASSERT_TRUE(loaded) << loaded.error().message;
  const auto classes = loader.loaded().at("good").classes();
  ASSERT_EQ(classes.size(), 2U);
  EXPECT_EQ(classes[0].name, "Lamp");
  EXPECT_EQ(classes[0].configuration.name(), "test.LampConfiguration");
  EXPECT_EQ(classes[0].configuration.fields()[0].range, (Range{0, 1}));
  EXPECT_EQ(classes[0].defaults, R"({"brightness":0.5})");
  EXPECT_EQ(classes[1].name, "Socket");
  EXPECT_TRUE(classes[1].configuration.is_none());
}

TEST_F(PluginTest, RefusesAConfigurationOutOfRange) {
  ComponentLoader loader({kBuilt});

  const auto lamp = loader.Create("good", "Lamp", "lamp", R"({"brightness": 2})");

  ASSERT_FALSE(lamp);
  EXPECT_EQ(lamp.error().message,
            "component 'lamp' (class Lamp): brightness: expected a number from 0 to 1, got number "
            "2 (plug-in good.so)");
}

TEST_F(PluginTest, ReportsAFileThatIsNotElf) {
  Write("text", "this is no library");
  Write("empty", "");
  Write("magic",
        "\x7f"
        "ELF");

  EXPECT_THAT(Refusal("text", folder), MatchesRegex("expected a shared library for .*, found a "
                                                    "file that begins with 'this is no libra'"));
  EXPECT_THAT(Refusal("empty", folder), HasSubstr("found an empty file"));
  EXPECT_THAT(Refusal("magic", folder), HasSubstr("found a file that ends after 4 B"));
}

TEST_F(PluginTest, RefusesATruncatedFile) {
  const std::string whole = Content(kBuilt / "good.so");
  const std::string size = std::to_string(whole.size());
  for (std::size_t part = 1; part < 10; ++part) {
    const std::size_t kept = whole.size() * part / 10;
    Write("cut", whole.substr(0, kept));
    EXPECT_THAT(
        Refusal("cut", folder),
        HasSubstr("found an incomplete file: " + std::to_string(kept) + " of " + size + " B"));
  }
}

TEST_F(PluginTest, ReportsAPlugInForAnotherMachine) {
  EXPECT_THAT(RefusalOfPatched(18, std::string("\x28\0", 2)), HasSubstr("found one for arm"));
  EXPECT_THAT(RefusalOfPatched(18, std::string("\x34\x12", 2)),
              HasSubstr("found one for machine 4660"));
  EXPECT_THAT(RefusalOfPatched(4, "\x01"), HasSubstr("found a library with another word size"));
  EXPECT_THAT(RefusalOfPatched(16, std::string("\x01\0", 2)),
              HasSubstr("found an object file or a program"));
}

TEST_F(PluginTest, NamesAMissingDependency) {
  EXPECT_EQ(Refusal("missing_dependency"),
            "a library that this library needs is missing: "
            "libtest_plugin_gone_dependency.so; install the missing library, or add its folder to "
            "LD_LIBRARY_PATH");
}

TEST_F(PluginTest, NamesTheMissingVersionOfTendon) {
  EXPECT_EQ(Refusal("missing_version"),
            "a library that this library needs is missing: libtendon_core.so.7.2; build the "
            "plug-in again with this version of Tendon, or install that one");
}

TEST_F(PluginTest, NamesAMissingSymbol) {
  EXPECT_EQ(Refusal("missing_symbol"),
            "no library that this library needs has the symbol lamp::SwitchOn(int); link the "
            "library that has it, and build the plug-in again with this version of Tendon");
}

TEST_F(PluginTest, RefusesALibraryWithoutEntryPoint) {
  EXPECT_EQ(
      Refusal("no_entry"),
      "expected the function TendonRegisterComponents, found none: either the file is not a "
      "plug-in, or -fvisibility=hidden or a missing extern \"C\" hides the function; define it "
      "outside of any namespace, and include tendon/manager/component_registry.h");
}

TEST_F(PluginTest, TheHeaderExportsTheEntryOfALibraryThatHidesItsFunctions) {
  const auto loaded = LoadPlugin(kBuilt / "hidden.so");

  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->registry.class_names(), std::vector<std::string>{"Lamp"});
}

TEST_F(PluginTest, NamesBothBinaryInterfacesIfTheyDiffer) {
  const std::string ours = DescribePluginAbi(TendonPluginAbi());
  EXPECT_EQ(Refusal("other_abi"), "expected " + ours +
                                      ", found tendon 7.2, C++ ABI 1011 with old strings; build "
                                      "the plug-in again against this version of Tendon");
  EXPECT_THAT(Refusal("no_abi"), HasSubstr("expected the function TendonPluginAbi, found none"));
}

TEST_F(PluginTest, KnowsTheVersionOfTheProject) {
  const std::string version = TENDON_VERSION;
  const std::string without_patch = version.substr(0, version.rfind('.'));
  EXPECT_EQ(DescribePluginAbi(TendonPluginAbi()).find("tendon " + without_patch + ","), 0U);
}

TEST_F(PluginTest, ACrashOnLoadingDoesNotHarmTheProcess) {
  EXPECT_THAT(Refusal("crashes"), MatchesRegex("the library cannot be loaded: loading "
                                               "it ends the process with (SIGSEGV|exit code .*)"));
}

TEST_F(PluginTest, ReportsAPlugInThatExits) {
  EXPECT_EQ(Refusal("exits"),
            "the library cannot be loaded: loading it ends the process with exit code 0");
}

TEST_F(PluginTest, QuotesAnExceptionOfTheStartUp) {
  EXPECT_EQ(Refusal("throws_at_start"),
            "the library cannot be loaded: its start-up threw: no calibration");
}

TEST_F(PluginTest, ReportsAPlugInThatNeverFinishesLoading) {
  const auto loaded = LoadPlugin(kBuilt / "never_finishes.so", std::chrono::milliseconds(200));

  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().message,
              HasSubstr("the library cannot be loaded: loading it has not finished after 200 ms"));
}

TEST_F(PluginTest, QuotesAnExceptionOfTheRegistration) {
  EXPECT_EQ(Refusal("throws_on_registration"),
            "expected TendonRegisterComponents to return, but it threw: an exception "
            "that does not derive from std::exception");
}

TEST_F(PluginTest, NamesAClassRegisteredTwice) {
  EXPECT_EQ(Refusal("duplicate_class"),
            "expected TendonRegisterComponents to return, but it threw: component class "
            "'Lamp' is registered twice");
}

TEST_F(PluginTest, RefusesANameOutsideItsFolders) {
  ComponentLoader loader({folder / "inner"});
  fs::create_directories(folder / "inner");
  fs::copy_file(kBuilt / "good.so", folder / "good.so");
  for (const char* name : {"../good", "inner/../good", "/tmp/good", "good.so", "..", ""}) {
    const auto loaded = loader.Load(name);
    ASSERT_FALSE(loaded) << name;
    EXPECT_EQ(loaded.error().code, ErrorCode::kInvalid) << name;
  }
}

TEST_F(PluginTest, LoadsAPlugInOnceItIsRepaired) {
  ComponentLoader loader({folder});
  const fs::path file = Write("lamp", "nothing yet");
  ASSERT_FALSE(loader.Load("lamp"));

  fs::copy_file(kBuilt / "good.so", file, fs::copy_options::overwrite_existing);

  const auto loaded = loader.Load("lamp");
  EXPECT_TRUE(loaded) << loaded.error().message;
}

TEST_F(PluginTest, AnOverwrittenPlugInKeepsRunning) {
  ComponentLoader loader({folder});
  fs::copy_file(kBuilt / "good.so", folder / "lamp.so");
  ASSERT_TRUE(loader.Load("lamp"));
  ASSERT_TRUE(IsMapped("lamp.so"));
  ASSERT_EQ(Content("/proc/self/maps").find((folder / "lamp.so").string()), std::string::npos);

  Write("lamp", "nothing of what was there");

  EXPECT_TRUE(loader.Create("lamp", "Lamp", "lamp", ""));
  const std::uint64_t before = loader.files()->revision();
  loader.files()->Update();
  EXPECT_NE(loader.files()->revision(), before);
  const auto files = loader.files()->descriptions();
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0].name, "lamp");
  EXPECT_EQ(files[0].file, (folder / "lamp.so").string());
  EXPECT_EQ(files[0].state, PluginState::kChanged);
  EXPECT_GE(files[0].written_now, files[0].written);
  const std::uint64_t now = loader.files()->revision();
  loader.files()->Update();
  EXPECT_EQ(loader.files()->revision(), now) << "nothing has changed since";
}

TEST_F(PluginTest, SeveralLoadersShareOnePlugIn) {
  fs::copy_file(kBuilt / "good.so", folder / "once.so");
  ComponentLoader first({folder});
  ComponentLoader second({folder});
  const auto mappings = [] {
    std::istringstream maps(Content("/proc/self/maps"));
    std::size_t count = 0;
    for (std::string line; std::getline(maps, line);) {
      count += line.find("/once.so") != std::string::npos ? 1 : 0;
    }
    return count;
  };

  ASSERT_TRUE(first.Load("once"));
  const std::size_t before = mappings();
  ASSERT_TRUE(second.Load("once"));

  EXPECT_GT(before, 0U);
  EXPECT_EQ(mappings(), before);
  EXPECT_TRUE(second.Create("once", "Lamp", "lamp", ""));
}

TEST_F(PluginTest, FindsALibraryNextToTheOriginalFile) {
  ComponentLoader loader({kBuilt});

  const auto loaded = loader.Load("needs_beside");

  EXPECT_TRUE(loaded) << loaded.error().message;
}

}  // namespace
}  // namespace tendon
