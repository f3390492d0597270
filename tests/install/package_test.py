#!/usr/bin/env python3
"""package_test.py --cmake CMAKE --compiler C++ --build FOLDER --version VERSION PART...: proves that the
installed files describe themselves: to CMake, to pkg-config, to the loader and to a lawyer."""

import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from installed import environment_of_a_user, install, run

MINIMAL = """\
cmake_minimum_required(VERSION 3.25)
project(minimal LANGUAGES CXX)
find_package(tendon {version} REQUIRED COMPONENTS {component})
"""


def check_unknown_component(arguments, prefix, folder):
    """Fails if find_package() does not say which components there are."""
    libraries = [part for part in ("core", "network", "ice", "eigen") if part in arguments.parts]
    (folder / "CMakeLists.txt").write_text(MINIMAL.format(version=arguments.version, component="core nework"))
    done = subprocess.run(
        [arguments.cmake, "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={prefix}",
         f"-DCMAKE_CXX_COMPILER={arguments.compiler}"], text=True, capture_output=True, check=False)
    said = " ".join(done.stderr.split())
    expected = ("tendon has no component 'nework' here. Its components are: core, network, ice, eigen. Installed are: "
                f"{', '.join(libraries)}.")
    if done.returncode == 0 or expected not in said:
        sys.exit(f"find_package with a component that does not exist: expected {expected!r}, found {said!r}")


def check_pkg_config(arguments, prefix, folder):
    """Builds a program with nothing but a compiler and pkg-config, and runs it."""
    environment = environment_of_a_user(folder, PKG_CONFIG_PATH=prefix / "lib/pkgconfig")
    for part in ("network", "ice", "eigen"):
        if part in arguments.parts:
            flags = run("pkg-config", "--cflags", "--libs", f"tendon-{part} = {arguments.version}", env=environment)
            places = set(re.findall(r"-[IL](\S+)", flags))
            if str(prefix / "include") not in {str(Path(place).resolve()) for place in places}:
                sys.exit(f"pkg-config tendon-{part}: expected {prefix}/include, found {flags}")
    source = folder / "name.cpp"
    source.write_text("#include <tendon/base/status.h>\n"
                      "int main() { return tendon::ToString(tendon::Status::kDone) == \"done\" ? 0 : 1; }\n")
    flags = run("pkg-config", "--cflags", "--libs", "tendon-core", env=environment).split()
    program = folder / "name"
    run(arguments.compiler, "-std=c++20", source, "-o", program, *flags, f"-Wl,-rpath,{prefix}/lib")
    run(program, env=environment)
    return program


def check_other_version(arguments, prefix, program, folder):
    """Puts another minor version into the place of this one: the program says which version it needs."""
    major, minor, patch = arguments.version.split(".")
    library = prefix / "lib" / f"libtendon_core.so.{major}.{minor}"
    if library.resolve().name != f"{library.name}.{patch}":
        sys.exit(f"expected {library} to be a link to version {arguments.version}, found {library.resolve()}")
    library.rename(library.with_name(f"libtendon_core.so.{major}.{int(minor) + 1}"))
    done = subprocess.run([program], text=True, capture_output=True, check=False, env=environment_of_a_user(folder))
    if done.returncode == 0 or f"{library.name}: cannot open shared object file" not in done.stderr:
        sys.exit(f"a program of version {major}.{minor} with libraries of the next version: expected that it does not "
                 f"start and names {library.name}, found exit code {done.returncode} and {done.stderr!r}")


def check_licences(prefix):
    texts = prefix / "share/doc/tendon"
    for text in ("LICENSE", "licences/lgpl-2.1.txt", "licences/qwt.txt"):
        if not (texts / text).is_file():
            sys.exit(f"expected the licence text {texts / text}, found none")


def main():
    parser = argparse.ArgumentParser()
    for name in ("--cmake", "--build", "--compiler", "--version"):
        parser.add_argument(name, required=True)
    parser.add_argument("parts", nargs="+")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary).resolve()
        prefix = install(arguments, folder)
        check_licences(prefix)
        check_unknown_component(arguments, prefix, folder)
        program = check_pkg_config(arguments, prefix, folder)
        check_other_version(arguments, prefix, program, folder)


if __name__ == "__main__":
    main()
