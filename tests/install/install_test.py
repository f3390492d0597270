#!/usr/bin/env python3
"""install_test.py --cmake CMAKE --compiler C++ --build FOLDER PART...: proves that the installed files are
sufficient.

Installs the parts into a temporary folder, and checks that no included header is missing. Builds the plug-in lamp/ as a
user would, with find_package, and runs it in the installed lcm.
"""

import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from installed import environment_of_a_user, free_port, install, run, running, wait_for

LAMP = Path(__file__).resolve().parent / "lamp"


def check_headers(include):
    """Fails if an installed header includes a header of Tendon that is not installed."""
    for header in include.rglob("*.h"):
        for name in re.findall(r"#include <(tendon/[^>]+)>", header.read_text(encoding="utf-8")):
            if not (include / name).is_file():
                sys.exit(f"{header.relative_to(include)} includes <{name}>, which is not installed")


def build_lamp(arguments, compiler, prefix, folder):
    run(arguments.cmake, "-S", LAMP, "-B", folder, f"-DCMAKE_PREFIX_PATH={prefix}",
        f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCOMPONENTS={';'.join(libraries(arguments))}")
    run(arguments.cmake, "--build", folder)


def libraries(arguments):
    return [part for part in arguments.parts if part in ("core", "network", "ice", "eigen")]


def check_pages(share):
    for page in ("man/man1/gcm.1", "man/man1/gcm-watch.1", "bash-completion/completions/gcm",
                 "zsh/site-functions/_gcm", "fish/vendor_completions.d/gcm.fish"):
        if not (share / page).read_text(encoding="utf-8"):
            sys.exit(f"{page} is empty")


def run_lamp(prefix, plugins, folder):
    environment = environment_of_a_user(folder, TENDON_COMPONENTS=plugins)
    address = f"127.0.0.1:{free_port()}"
    gcm = [prefix / "bin" / "gcm", "--gcm", address, "--timeout", "20000"]

    def says(*words, text):
        done = subprocess.run([*gcm, *words], env=environment, text=True, capture_output=True, check=False)
        return done.returncode == 0 and text in done.stdout

    with running(*gcm, "serve", env=environment) as server:
        wait_for("the GCM", lambda: says("ls", text=""), server)
        lcm = [prefix / "bin" / "lcm", "--name", "room", "--gcm", address, "--system", LAMP / "system.json",
               "--timeout", "20000"]
        with running(*lcm, env=environment) as room:
            wait_for("the lamp", lambda: says("get", "room/lamp/state.Brightness", text="0.75"), server, room)
            wait_for("an installed plug-in", lambda: says("ls", "room", text="host_monitor"), server, room)


def main():
    parser = argparse.ArgumentParser()
    for name in ("--cmake", "--build"):
        parser.add_argument(name, required=True)
    parser.add_argument("--compiler", action="append", required=True)
    parser.add_argument("parts", nargs="+")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        prefix = install(arguments, folder)
        check_headers(prefix / "include")
        check_pages(prefix / "share")
        for compiler in arguments.compiler:
            plugins = folder / Path(compiler).name
            build_lamp(arguments, compiler, prefix, plugins)
            run_lamp(prefix, plugins, folder)
            print(f"the plug-in that {compiler} has built runs in the installed lcm")


if __name__ == "__main__":
    main()
