#!/usr/bin/env python3
"""Tests each rule of architecture.py with small trees that break the rule, and with trees that follow it."""

import tempfile
import unittest
from pathlib import Path

import architecture

# The word is put together here because the rule also checks this file.
LEFT_OVER = "TO" + "DO"


def include(*names):
    return "#pragma once\n" + "".join(f"#include <{name}>\n" for name in names)


def in_namespace(*definitions):
    return "\n".join(("#pragma once", "namespace tendon {", *definitions, "}  // namespace tendon\n"))


def installs(*names):
    return f"target_sources(a\n  PUBLIC FILE_SET HEADERS BASE_DIRS core\n  FILES\n    {' '.join(names)}\n)\n"


def builds(*names):
    return f"add_library(all\n  {' '.join(names)})\n"


def function(lines, indent=""):
    """A function of this number of lines, with a signature of two lines."""
    text = ["Result<int> Run(int first,", "                int last) {", *["  Step();"] * (lines - 3), "}"]
    return "".join(f"{indent}{line}\n" for line in text)


PAGE = architecture.FOLDER_PAGE
TEST_PAGE = architecture.TEST_PAGE


def describes(*folders):
    rows = "".join(f"| `{folder}` | a subject |\n" for folder in folders)
    return f"### The window: `gcm_gui`\n| folder | it holds |\n|---|---|\n{rows}"


# For each rule, the trees that break it. Each tree comes with the place and a part of the message.
BROKEN = {
    "ice_stays_in_its_folder": [
        ({"lcm/main.cpp": include("string", "Ice/Ice.h")}, "lcm/main.cpp:3", "core/tendon/ice alone"),
        ({"core/tendon/gcm/a.cpp": include("IceSSL/IceSSL.h")}, "core/tendon/gcm/a.cpp:2", "core/tendon/ice alone"),
        ({"tests/system/a_test.cpp": include("Ice/Ice.h")}, "tests/system/a_test.cpp:2", "core/tendon/ice alone"),
    ],
    "qt_stays_in_the_window": [
        ({"gcm_console/a.cpp": include("QString")}, "gcm_console/a.cpp:2", "gcm_gui alone"),
        ({"core/tendon/gcm/a.cpp": include("QtCore/QObject")}, "core/tendon/gcm/a.cpp:2", "gcm_gui alone"),
        ({"tests/core/a_test.cpp": include("qwt_plot.h")}, "tests/core/a_test.cpp:2", "gcm_gui alone"),
    ],
    "parts_include_what_they_may": [
        ({"core/tendon/gcm/a.cpp": include("gcm_console/table.h"), "gcm_console/table.h": include()},
         "core/tendon/gcm/a.cpp:2", "core may not include"),
        ({"lcm/main.cpp": '#include "../gcm_gui/session.h"\n', "gcm_gui/session.h": include()},
         "lcm/main.cpp:1", "lcm may not include"),
        ({"program/a.cpp": include("gcm_console/table.h"), "gcm_console/table.h": include()},
         "program/a.cpp:2", "program may not include"),
        ({"components/arm/a.cpp": include("program/exit_code.h"), "program/exit_code.h": include()},
         "components/arm/a.cpp:2", "components may not include"),
        ({"gcm_gui/a.cpp": include("components/arm/arm.h"), "components/arm/arm.h": include()},
         "gcm_gui/a.cpp:2", "gcm_gui may not include"),
        ({"core/tendon/base/a.cpp": include("tests/support/fake.h"), "tests/support/fake.h": include()},
         "core/tendon/base/a.cpp:2", "core may not include"),
    ],
    "components_need_core_alone": [
        ({"components/arm/arm.h": include("tendon/process/process.h")}, "components/arm/arm.h:2", "tendon::core alone"),
        ({"components/arm/arm.h": include("spdlog/spdlog.h")}, "components/arm/arm.h:2", "tendon::core alone"),
        ({"components/arm/CMakeLists.txt": "target_link_libraries(arm PRIVATE tendon::core tendon::network)\n"},
         "components/arm/CMakeLists.txt:1", "not tendon::network"),
    ],
    "layers_look_down": [
        ({"core/tendon/base/a.h": include("tendon/lockfree/b.h")}, "core/tendon/base/a.h:2", "not below it"),
        ({"core/tendon/payload/a.h": include("tendon/lockfree/b.h")}, "core/tendon/payload/a.h:2", "not below it"),
        ({"core/tendon/state/a.cpp": include("tendon/interface/b.h")}, "core/tendon/state/a.cpp:2", "not below it"),
        ({"core/tendon/manager/a.cpp": include("tendon/middleware/b.h")}, "core/tendon/manager/a.cpp:2", "not below"),
        ({"core/tendon/gcm/a.cpp": include("tendon/ice/b.h")}, "core/tendon/gcm/a.cpp:2", "not below it"),
        ({"core/tendon/task/a.cpp": '#include "../manager/b.h"\n', "core/tendon/manager/b.h": include()},
         "core/tendon/task/a.cpp:1", "not below it"),
        ({"core/tendon/task/a.cpp": include("tendon/helpers/b.h")}, "core/tendon/task/a.cpp:2", "not below it"),
        ({"core/tendon/helpers/a.h": include()}, "core/tendon/helpers/a.h:1", "is no layer"),
        ({"core/tendon/tendon.h": include("tendon/process/b.h")}, "core/tendon/tendon.h:2", "not below it"),
        ({"core/tendon/task/a.h": include("tendon/tendon.h")}, "core/tendon/task/a.h:2", "not below it"),
    ],
    "core_headers_need_the_standard_library_alone": [
        ({"core/tendon/base/log.h": include("spdlog/spdlog.h")}, "core/tendon/base/log.h:2", "standard library alone"),
        ({"core/tendon/payload/a.h": include("Eigen/Core")}, "core/tendon/payload/a.h:2", "standard library alone"),
        ({"core/tendon/base/os/a.h": include("pthread.h")}, "core/tendon/base/os/a.h:2", "standard library alone"),
    ],
    "the_operating_system_stays_in_base_os": [
        ({"core/tendon/middleware/tcp.cpp": include("sys/socket.h")}, "core/tendon/middleware/tcp.cpp:2", "base/os"),
        ({"lcm/main.cpp": include("unistd.h")}, "lcm/main.cpp:2", "base/os"),
        ({"components/monitor/a.cpp": include("netinet/in.h")}, "components/monitor/a.cpp:2", "base/os"),
    ],
    "atomics_stay_in_lockfree_and_state": [
        ({"core/tendon/task/a.h": include("atomic")}, "core/tendon/task/a.h:2", "atomics live in"),
        ({"gcm_gui/a.cpp": "std::atomic<int> count;\n"}, "gcm_gui/a.cpp:1", "atomics live in"),
    ],
    "code_has_no_macros": [
        ({"lcm/a.cpp": "#define TWICE(x) ((x) + (x))\n"}, "lcm/a.cpp:1", "TWICE is a macro"),
        ({"tests/support/a.h": "#pragma once\n  #  define LIMIT 3\n"}, "tests/support/a.h:2", "LIMIT is a macro"),
    ],
    "headers_are_included_once": [
        ({"lcm/a.h": "// nothing\n"}, "lcm/a.h:1", "#pragma once"),
    ],
    "headers_name_what_they_use": [
        ({"lcm/a.h": include("string") + "std::string_view name();\n"}, "lcm/a.h:3", "std::string_view needs #include"),
        ({"core/tendon/base/a.h": include("cstring") + "/* the\nbytes */ std::byte first;\n"},
         "core/tendon/base/a.h:4", "std::byte needs #include <cstddef> in this header"),
        ({"gcm_gui/a.h": include("gcm_gui/b.h") + "std::size_t count();\n", "gcm_gui/b.h": include("cstddef")},
         "gcm_gui/a.h:3", "std::size_t needs #include <cstddef> in this header"),
        ({"program/a.h": include() + "void Set(int x = 1'000, char c = '\"', std::uint8_t y = '\"');\n"},
         "program/a.h:2", "std::uint8_t needs #include <cstdint>"),
    ],
    "own_header_first": [
        ({"core/tendon/task/b.cpp": include("tendon/task/a.h", "tendon/task/b.h"), "core/tendon/task/a.h": include(),
          "core/tendon/task/b.h": include()},
         "core/tendon/task/b.cpp:2", "its own header, core/tendon/task/b.h, not <tendon/task/a.h>"),
        ({"lcm/a.cpp": "", "lcm/a.h": include()}, "lcm/a.cpp:1", "its own header, lcm/a.h"),
    ],
    "tests_have_plain_names": [
        ({"tests/core/a_test.cpp": "\nTEST(Queue, WhatIsPushedIsPopped) {\n"},
         "tests/core/a_test.cpp:2", "is a riddle"),
        ({"tests/core/a_test.cpp": "TEST_F(Queue,\n       ThatIsFullRefuses) {\n"},
         "tests/core/a_test.cpp:1", "ThatIsFullRefuses"),
        ({"tests/conformance/a_test.cpp": "TEST_P(Link, WhoeverWaitsIsWoken) {\n"},
         "tests/conformance/a_test.cpp:1", "WhoeverWaitsIsWoken"),
    ],
    "nothing_is_left_over": [
        ({"lcm/a.cpp": f"// {LEFT_OVER}: later\n"}, "lcm/a.cpp:1", "do it, or open an issue"),
        ({"tools/setup": f"\n# {LEFT_OVER}\n"}, "tools/setup:2", "do it, or open an issue"),
    ],
    "functions_are_short": [
        ({"lcm/a.cpp": function(61)}, "lcm/a.cpp:1", "a function of 61 lines"),
        ({"lcm/a.cpp": "class A {\n public:\n" + function(61, "  ") + "};\n"}, "lcm/a.cpp:3", "a function of 61 lines"),
        ({"lcm/a.cpp": function(20) + "\n" + function(70)}, "lcm/a.cpp:22", "a function of 70 lines"),
    ],
    "scripts_are_narrow": [
        ({"tools/a": "#!/bin/sh\n" + "a" * 121}, "tools/a:2", "121 columns"),
        ({"lcm/CMakeLists.txt": "a" * 121}, "lcm/CMakeLists.txt:1", "121 columns"),
    ],
    "types_have_names_of_their_own": [
        ({"core/tendon/a.h": in_namespace("class Link {\n};"), "tests/b_test.cpp": in_namespace("struct Link {\n};")},
         "tests/b_test.cpp:3", "tendon::Link is the name of another type, in core/tendon/a.h:3"),
        ({"lcm/a.h": in_namespace("class Link final : public Base {"), "lcm/b.h": in_namespace("enum class Link {")},
         "lcm/b.h:3", "tendon::Link"),
    ],
    "joined_sources_share_no_names": [
        ({"core/tendon/gcm/a.cpp": in_namespace("namespace {\nconstexpr int kMax = 1;\n}  // namespace"),
          "core/tendon/proxy/b.cpp": in_namespace("namespace {\n\nconstexpr int kMax = 2;\n}  // namespace")},
         "core/tendon/proxy/b.cpp:5", "kMax is private to core/tendon/gcm/a.cpp:4, too"),
        ({"core/tendon/gcm/a.cpp": in_namespace("namespace {\nusing Kind = Step::Kind;\n}  // namespace"),
          "core/tendon/gcm/b.cpp": in_namespace("namespace {\nusing Kind = Flaw::Kind;\n}  // namespace")},
         "core/tendon/gcm/b.cpp:4", "Kind is private to"),
    ],
    "helpers_hide_no_declared_functions": [
        ({"lcm/CMakeLists.txt": builds("a.cpp", "b.cpp"), "lcm/words.h": in_namespace("std::string Quoted(View word);"),
          "lcm/a.cpp": include("lcm/words.h"),
          "lcm/b.cpp": in_namespace("namespace {\nstd::string Quoted(const std::string& text) {\n}\n}  // namespace")},
         "lcm/b.cpp:4", "Quoted is also the function of lcm/words.h:3"),
        ({"lcm/CMakeLists.txt": builds("a.cpp", "b.cpp"), "lcm/all.h": include("lcm/clock.h"),
          "lcm/clock.h": in_namespace("[[nodiscard]] const Map<int, Clock>& SteadyClock() noexcept;"),
          "lcm/a.cpp": include("lcm/all.h"),
          "lcm/b.cpp": in_namespace("namespace os {\nnamespace {\nusing SteadyClock = Other;\n}  // namespace",
                                    "}  // namespace os")},
         "lcm/b.cpp:5", "SteadyClock is also the function of lcm/clock.h:3"),
    ],
    "folders_of_a_layer_have_no_cycle": [
        ({"core/tendon/gcm/wiring/a.h": include("tendon/gcm/server/b.h"),
          "core/tendon/gcm/server/b.h": include("tendon/gcm/system/c.h"),
          "core/tendon/gcm/system/c.h": include("tendon/gcm/wiring/d.h"), "core/tendon/gcm/wiring/d.h": include()},
         "core/tendon/gcm/server/b.h:2", "gcm/server may not include <tendon/gcm/system/c.h>, because gcm/system"),
    ],
    "installed_headers_include_no_internal_ones": [
        ({"core/tendon/base/CMakeLists.txt": installs("a.h"), "core/tendon/base/a.h": include("tendon/base/b.h"),
          "core/tendon/base/b.h": include()},
         "core/tendon/base/a.h:2", "<tendon/base/b.h> is not"),
    ],
    "headers_of_core_are_in_a_file_set": [
        ({"core/tendon/base/CMakeLists.txt": installs("a.h") + "target_sources(a PRIVATE b.h)\n",
          "core/tendon/base/a.h": include(), "core/tendon/base/b.h": include()},
         "core/tendon/base/b.h:1", "in no file set"),
        ({"core/tendon/base/os/a.h": include(), "core/tendon/base/CMakeLists.txt": installs("a.h")},
         "core/tendon/base/os/a.h:1", "in no file set"),
    ],
    "folders_are_built": [
        ({"CMakeLists.txt": "add_subdirectory(lcm)\n", "lcm/CMakeLists.txt": "", "lcms/CMakeLists.txt": ""},
         "lcms/CMakeLists.txt:1", "nobody builds it; add it to ./CMakeLists.txt"),
    ],
    "folders_are_described": [
        ({PAGE: describes("plot"), "gcm_gui/plot/a.h": include(), "gcm_gui/plot/canvas/a.h": include()},
         PAGE + ":1", "gcm_gui/plot/canvas has no line"),
        ({PAGE: describes("plot", "graph"), "gcm_gui/plot/a.h": include()},
         PAGE + ":5", "there is no folder gcm_gui/graph with code"),
        ({PAGE: describes("plot", "plot"), "gcm_gui/plot/a.h": include()}, PAGE + ":5", "has a line already"),
    ],
    "readme_names_the_layers": [
        ({"README.md": "core/tendon/\n  base    errors\n", "core/tendon/base/a.h": include(),
          "core/tendon/state/a.h": include()}, "README.md:1", "no line for core/tendon/state"),
        ({"README.md": "core/tendon/\n  base    errors\n"}, "README.md:2", "there is no folder core/tendon/base"),
    ],
    "tests_mirror_the_code": [
        ({TEST_PAGE: "", "tests/core/odd/a_test.cpp": ""}, TEST_PAGE + ":1", "tests/core/odd has no counterpart"),
        ({TEST_PAGE: "", "core/tendon/state/a.h": include(), "tests/core/a_test.cpp": ""},
         TEST_PAGE + ":1", "core/tendon/state has no counterpart, tests/core/state"),
        ({TEST_PAGE: "\n| `lcm`, `tests/core/odd` | it |\n", "lcm/main.cpp": ""},
         TEST_PAGE + ":2", "there is no folder tests/core/odd"),
    ],
}
KEPT = {
    "ice_stays_in_its_folder": [
        {"core/tendon/ice/a.cpp": include("Ice/Ice.h"), "tests/core/ice/a_test.cpp": include("Ice/Ice.h")},
    ],
    "qt_stays_in_the_window": [
        {"gcm_gui/plot/a.cpp": include("QString", "qwt_plot.h"), "tests/gcm_gui/a_test.cpp": include("QTest")},
        {"lcm/a.cpp": include("queue"), "lcm/queue.h": include(), "lcm/b.cpp": '#include "queue.h"\n'},
    ],
    "parts_include_what_they_may": [
        {"gcm_gui/a.cpp": include("gcm_console/table.h"), "gcm_console/table.h": include("tendon/gcm/catalogue.h")},
        {"tests/gcm_gui/a_test.cpp": include("gcm_gui/session.h"), "gcm_gui/session.h": include()},
    ],
    "components_need_core_alone": [
        {"components/arm/arm.cpp": include("vector", "Eigen/Core", "tendon/task/periodic_task.h", "components/arm/a.h"),
         "components/arm/a.h": include(),
         "components/arm/CMakeLists.txt": "target_link_libraries(arm PRIVATE tendon::core)\n"},
    ],
    "layers_look_down": [
        {"core/tendon/state/a.h": include("tendon/base/b.h", "tendon/lockfree/b.h", "tendon/state/b.h"),
         "core/tendon/ice/a.h": include("tendon/gcm/b.h", "tendon/middleware/b.h"),
         "core/tendon/tendon.h": include("tendon/manager/b.h", "tendon/task/b.h")},
    ],
    "core_headers_need_the_standard_library_alone": [
        {"core/tendon/base/log.cpp": include("spdlog/spdlog.h"), "core/tendon/payload/eigen.h": include("Eigen/Core")},
    ],
    "the_operating_system_stays_in_base_os": [
        {"core/tendon/base/os/a.cpp": include("unistd.h"), "tests/support/a.cpp": include("sys/wait.h")},
    ],
    "atomics_stay_in_lockfree_and_state": [
        {"core/tendon/lockfree/a.h": include("atomic"), "tests/a_test.cpp": include("atomic"),
         "lcm/a.cpp": "Load();  // unlike std::atomic, this waits\n"},
    ],
    "code_has_no_macros": [{"lcm/a.cpp": "#ifdef __linux__\n#endif\n"}],
    "headers_are_included_once": [{"lcm/a.h": "#pragma once\n"}],
    "headers_name_what_they_use": [
        {"lcm/a.h": include("cstring", "string") + "// std::vector\nstd::string b(std::size_t c);\n"
         + "/* std::map\nstd::span */\n"
         + 'constexpr auto kText = "std::move";\nconstexpr auto kLong = R"(\nstd::byte)";\n',
         "lcm/b.cpp": "std::optional<int> a;\n", "tests/support/a.h": "#pragma once\nstd::array<int, 2> a;\n"},
    ],
    "own_header_first": [
        {"core/tendon/task/b.cpp": "// a comment\n" + include("tendon/task/b.h", "tendon/task/a.h"),
         "core/tendon/task/a.h": include(), "core/tendon/task/b.h": include(),
         "lcm/main.cpp": include("lcm/a.h"), "lcm/a.h": include(),
         "tests/lcm/a.cpp": include("string"), "tests/lcm/a.h": include()},
    ],
    "tests_have_plain_names": [
        {"tests/core/a_test.cpp": "TEST(Queue, ReturnsWhatWasPushed) {\nTEST(Queue, WholeBatchesAreKept) {\n",
         "core/a.cpp": "TEST(Queue, WhatIsPushedIsPopped) {\n"},
    ],
    "nothing_is_left_over": [{"lcm/a.cpp": f"// {LEFT_OVER}_list is one word\n"}],
    "functions_are_short": [
        {"lcm/a.cpp": function(60)},
        {"lcm/a.cpp": "template <typename T,\n          typename U>\nclass A {\n" + "  int a;\n" * 80 + "};\n"},
        {"lcm/a.cpp": "constexpr int kTable[] = {\n" + "    1,\n" * 80 + "};\n"},
        {"lcm/a.cpp": "//   void Example() {\n" + "int a;\n" * 80},
    ],
    "scripts_are_narrow": [{"tools/a": "a" * 120, "docs/a.md": "a" * 200, "lcm/a.cpp": "a" * 200}],
    "types_have_names_of_their_own": [
        {"lcm/a.h": in_namespace("class Link;", "class Link {\n  class End {\n  };\n};"),
         "lcm/b.h": in_namespace("class Link;", "class Other {\n  class End {\n  };\n};")},
        {"lcm/a.cpp": in_namespace("namespace {\nclass Link {\n};\n}  // namespace"),
         "lcm/b.cpp": in_namespace("namespace {\nclass Link {\n};\n}  // namespace"),
         "lcm/c.cpp": in_namespace("class Link {\n};").replace("tendon", "program")},
    ],
    "joined_sources_share_no_names": [
        {"core/tendon/gcm/a.cpp": in_namespace("namespace {\nusing Kind = Step::Kind;\n}  // namespace"),
         "core/tendon/gcm/b.cpp": in_namespace("namespace {\nusing Kind = Step::Kind;\nclass End;\n}  // namespace"),
         "core/tendon/ice/b.cpp": in_namespace("namespace {\nusing Kind = Other::Kind;\n}  // namespace")},
        {"core/tendon/gcm/a.cpp": in_namespace("void Run() {\nconstexpr int kMax = 1;\n}"),
         "core/tendon/gcm/b.cpp": in_namespace("namespace server {\nnamespace {\nclass A {\n};\n}  // namespace",
                                               "}  // namespace server"),
         "core/tendon/gcm/c.cpp": in_namespace("namespace {\nclass A {\n};\n}  // namespace")},
    ],
    "helpers_hide_no_declared_functions": [
        # Functions of another target, of a separate namespace, of a class, and of a header that no source includes.
        {"lcm/CMakeLists.txt": builds("a.cpp", "b.cpp") + "add_library(other c.cpp d.cpp)  # b.cpp\n",
         "lcm/a.cpp": include("lcm/a.h"), "lcm/c.cpp": include("lcm/words.h"), "lcm/d.cpp": "",
         "lcm/a.h": in_namespace("namespace os {\nvoid Quoted(int word);\n}  // namespace os",
                                 "class Line {\n  void Quoted(int word);\n};", "constexpr int kLength = Quoted(1);",
                                 "void Line::Quoted(int word) {\n}"),
         "lcm/words.h": in_namespace("void Quoted(int word);"), "lcm/more.h": in_namespace("void Quoted(int word);"),
         "lcm/b.cpp": in_namespace("namespace {\nvoid Quoted(const char* word) {\n}\n}  // namespace")},
    ],
    "folders_of_a_layer_have_no_cycle": [
        {"core/tendon/gcm/a.h": include("tendon/gcm/wiring/b.h"),
         "core/tendon/gcm/wiring/b.h": include("tendon/gcm/c.h", "tendon/gcm/wiring/d.h", "tendon/gcm/system/e.h"),
         "core/tendon/gcm/wiring/d.h": include(), "core/tendon/gcm/system/e.h": include("tendon/gcm/c.h")},
    ],
    "installed_headers_include_no_internal_ones": [
        {"core/tendon/base/CMakeLists.txt": installs("a.h", "b.h")
         + "target_sources(a PRIVATE\n  FILE_SET internal TYPE HEADERS BASE_DIRS core FILES c.h)\n",
         "core/tendon/base/a.h": include("tendon/base/b.h", "string"), "core/tendon/base/b.h": include(),
         "core/tendon/base/c.h": include("tendon/base/d.h")},
    ],
    "headers_of_core_are_in_a_file_set": [
        {"core/tendon/base/CMakeLists.txt":
         "target_sources(a PRIVATE a.cpp\n  PUBLIC\n    FILE_SET HEADERS BASE_DIRS core\n    FILES\n      a.h\n"
         "  PRIVATE\n    FILE_SET internal TYPE HEADERS BASE_DIRS core\n    FILES\n      b.h os/c.h\n)\n",
         "core/tendon/base/a.h": include(), "core/tendon/base/b.h": include(), "core/tendon/base/os/c.h": include(),
         "lcm/a.h": include()},
    ],
    "folders_are_built": [
        {"CMakeLists.txt": "foreach(folder lcm core)\n", "lcm/CMakeLists.txt": "",
         "core/CMakeLists.txt": "foreach(folder base)\n", "core/tendon/base/CMakeLists.txt": ""},
        {"CMakeLists.txt": "", "example/CMakeLists.txt": "project(example)\n"},
    ],
    "folders_are_described": [
        {PAGE: describes("plot", "plot/canvas") + "## Threads\n| `network` | sends |\n",
         "gcm_gui/main.cpp": "", "gcm_gui/plot/a.h": include(), "gcm_gui/plot/canvas/a.h": include(),
         "lcm/main.cpp": "", "tests/gcm_gui/help/a_test.cpp": ""},
    ],
    "readme_names_the_layers": [
        {"README.md": "core/tendon/\n  base    errors\ncomponents/   more\n", "core/tendon/base/a.h": include(),
         "core/tendon/tendon.h": include()},
    ],
    "tests_mirror_the_code": [
        {TEST_PAGE: "| `tests/system`, `lcm` | both |\n| `core/tendon/state/a.h` | `tests/odd` |\n",
         "core/tendon/state/a.h": include(), "tests/core/state/a_test.cpp": "", "components/arm/a.h": include(),
         "tests/components/arm/a_test.cpp": "", "tests/system/faults/a_test.cpp": "", "lcm/main.cpp": ""},
    ],
}


class ArchitectureTest(unittest.TestCase):
    def violations(self, tree):
        with tempfile.TemporaryDirectory() as root:
            for path, text in tree.items():
                file = Path(root, path)
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text)
            return list(architecture.violations(root))

    def test_every_rule_is_shown_broken_and_kept(self):
        rules = {rule.__name__
                 for rule in (*architecture.FILE_RULES, *architecture.TREE_RULES)}

        self.assertEqual(rules, set(BROKEN))
        self.assertEqual(rules, set(KEPT))

    def test_a_broken_rule_is_reported_at_its_place(self):
        for rule, cases in BROKEN.items():
            for tree, place, sentence in cases:
                with self.subTest(rule=rule, place=place):
                    found = self.violations(tree)
                    self.assertTrue(any(v.startswith(place + ":") and sentence in v for v in found), found)

    def test_a_kept_rule_is_silent(self):
        for rule, trees in KEPT.items():
            for tree in trees:
                with self.subTest(rule=rule, files=list(tree)):
                    self.assertEqual(self.violations(tree), [])


if __name__ == "__main__":
    unittest.main()
