#!/usr/bin/env python3
"""install_test.py --cmake CMAKE --compiler C++ --build FOLDER PART...: proves that the installed files are
sufficient.

Installs the parts into a temporary folder, and checks that no included header is missing. Builds the plug-in lamp/ as a
user would, with find_package, and runs it in the installed lcm.
"""

import argparse
import contextlib
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "tools"))
from free_port import free_port

LAMP = Path(__file__).resolve().parent / "lamp"
TIMEOUT = 60  # s, for a machine that is busy


def run(*command, **options):
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\nended with {done.returncode}:\n{done.stdout[-4000:]}")
    return done.stdout


def install(arguments, prefix):
    for part in arguments.parts:
        run(arguments.cmake, "--install", arguments.build, "--prefix", prefix, "--component", part)


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


@contextlib.contextmanager
def running(*command, environment):
    """Runs a program until the end of the block. Its output goes to the output of this test."""
    process = subprocess.Popen(command, env=environment)
    try:
        yield process
    finally:
        process.terminate()
        process.wait(TIMEOUT)


def wait_for(what, succeeds, *processes):
    deadline = time.monotonic() + TIMEOUT
    while not succeeds():
        ended = [process.args[0] for process in processes if process.poll() is not None]
        if ended or time.monotonic() > deadline:
            sys.exit(f"{what} did not appear within {TIMEOUT} s; programs that ended: {ended}")
        time.sleep(0.1)


def check_pages(share):
    for page in ("man/man1/gcm.1", "man/man1/gcm-watch.1", "bash-completion/completions/gcm",
                 "zsh/site-functions/_gcm", "fish/vendor_completions.d/gcm.fish"):
        if not (share / page).read_text(encoding="utf-8"):
            sys.exit(f"{page} is empty")


def run_lamp(prefix, plugins, folder):
    environment = {**os.environ, "TENDON_COMPONENTS": str(plugins), "XDG_STATE_HOME": str(folder),
                   "XDG_RUNTIME_DIR": str(folder)}
    environment.pop("LD_LIBRARY_PATH", None)  # installed programs must find their libraries without it
    address = f"127.0.0.1:{free_port()}"
    gcm = [prefix / "bin" / "gcm", "--gcm", address, "--timeout", "20000"]

    def says(*words, text):
        done = subprocess.run([*gcm, *words], env=environment, text=True, capture_output=True, check=False)
        return done.returncode == 0 and text in done.stdout

    with running(*gcm, "serve", environment=environment) as server:
        wait_for("the GCM", lambda: says("ls", text=""), server)
        lcm = [prefix / "bin" / "lcm", "--name", "room", "--gcm", address, "--system", LAMP / "system.json",
               "--timeout", "20000"]
        with running(*lcm, environment=environment) as room:
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
        prefix = folder / "prefix"
        install(arguments, prefix)
        check_headers(prefix / "include")
        check_pages(prefix / "share")
        for compiler in arguments.compiler:
            plugins = folder / Path(compiler).name
            build_lamp(arguments, compiler, prefix, plugins)
            run_lamp(prefix, plugins, folder)
            print(f"the plug-in that {compiler} has built runs in the installed lcm")


if __name__ == "__main__":
    main()
