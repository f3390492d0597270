#!/usr/bin/env python3
"""subproject_test.py --cmake CMAKE --compiler C++ --source FOLDER [--ice]: proves that a project which takes Tendon in
with FetchContent gets the library, and nothing else.

Configures parent/ and looks at what a build would do. Compiles no source of Tendon: of the program of parent/ it checks
the syntax.
"""

import argparse
import json
import re
import shlex
import sys
import tempfile
from pathlib import Path

from installed import run

PARENT = Path(__file__).resolve().parent / "parent"


def expect(what, expected, found):
    if found != expected:
        sys.exit(f"{what}: expected {expected}, found {found}")


def main():
    parser = argparse.ArgumentParser()
    for name in ("--cmake", "--compiler", "--source"):
        parser.add_argument(name, required=True)
    parser.add_argument("--ice", action="store_true")
    arguments = parser.parse_args()
    libraries = ["core", "network", *(["ice"] if arguments.ice else [])]
    with tempfile.TemporaryDirectory() as temporary:
        build = Path(temporary) / "build"
        said = run(arguments.cmake, "-G", "Ninja", "-S", PARENT, "-B", build, f"-DTENDON={arguments.source}",
                   f"-DCMAKE_CXX_COMPILER={arguments.compiler}", f"-DTENDON_WITH_ICE={arguments.ice}")
        expect("settings that the parent has only with Tendon", "", re.search("left behind: (.*)", said)[1])

        linked = re.findall(r"Linking CXX .* (\S+?)(?:;|$)", run(arguments.cmake, "--build", build, "--", "-n"), re.M)
        expect("what the target `all` links", sorted([*(f"libtendon_{name}.so" for name in libraries), "robot"]),
               sorted(re.sub(r"\.so[.\d]*$", ".so", Path(file).name) for file in linked))

        commands = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
        ours = f"{arguments.source}/core/tendon/"
        expect("sources outside of the library", ["robot.cpp"],
               [Path(command["file"]).name for command in commands if not command["file"].startswith(ours)])

        robot = next(command for command in commands if command["file"].endswith("robot.cpp"))
        run(*shlex.split(robot["command"]), "-fsyntax-only", cwd=robot["directory"])

        prefix = Path(temporary) / "prefix"
        run(arguments.cmake, "--install", build, "--prefix", prefix)
        expect("installed files", [], list(prefix.rglob("*")))
        run(arguments.cmake, "-DTENDON_INSTALL=ON", build)
        run(arguments.cmake, "--install", build, "--prefix", prefix, "--component", "eigen")
        expect("a header with TENDON_INSTALL", True, (prefix / "include/tendon/payload/eigen.h").is_file())
        print(f"{len(commands)} sources, of which one is not of the library")


if __name__ == "__main__":
    main()
