#!/usr/bin/env python3
"""programs_test.py --cmake CMAKE --build FOLDER PART...: proves that each installed program starts without the source
tree, the build and the cache of tools/setup.

Installs the parts, moves them to another folder, and checks that every library which an installed file needs is either
a library of the system or an installed one. Then starts each program. The window opens without a screen and, if this
machine has Xvfb, on a virtual display.
"""

import argparse
import contextlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from installed import environment_of_a_user, free_port, install, run, running, wait_for

SYSTEM = ("/lib/", "/lib64/", "/usr/lib/", "/usr/lib64/")


def needed_libraries(file, environment):
    """Yields the name of each library that the file needs, and the path at which the loader finds it."""
    for line in run("ldd", file, env=environment).splitlines():
        if found := re.match(r"\s*(\S+) => (.+?)( \(0x\w+\))?$", line):
            yield found[1], found[2]


def check_libraries(prefix, environment):
    files = [*(prefix / "bin").iterdir(), *(prefix / "lib").rglob("*.so*")]
    wrong = []
    for file in files:
        for name, path in needed_libraries(file, environment):
            if not path.startswith((*SYSTEM, f"{prefix}/")):
                wrong.append(f"{file.relative_to(prefix)} needs {name}: expected a file of the system or of the "
                             f"installation, found {path}")
    if wrong:
        sys.exit("\n".join(wrong))
    print(f"{len(files)} installed programs and libraries need only each other and the system")


def check_versions(prefix, environment):
    for program in sorted((prefix / "bin").iterdir()):
        if program.name == "tendon-probe":
            for plugin in (prefix / "lib/tendon/components").iterdir():
                run(program, plugin, env=environment)
            continue
        said = run(program, "--version", env=environment)
        if not re.fullmatch(rf"{program.name} \d+\.\d+\.\d+\n", said):
            sys.exit(f"{program.name} --version: expected its name and version, found {said!r}")
    print("each program starts")


def opens(prefix, folder, environment):
    """Starts the window, which hosts a GCM, and waits until it has described what it shows."""
    description = folder / "ui.json"

    def shows_the_gcm():
        with contextlib.suppress(OSError, ValueError):
            return "gcm" in json.loads(description.read_text(encoding="utf-8"))["facts"]["processes"]
        return False

    command = (prefix / "bin" / "gcm-gui", "--no-tour", "--listen", f"127.0.0.1:{free_port()}", "--describe-ui",
               description)
    with running(*command, env=environment) as window:
        wait_for("the window", shows_the_gcm, window)
    description.unlink()


@contextlib.contextmanager
def virtual_display():
    end, answer = os.pipe()
    with running("Xvfb", "-displayfd", str(answer), "-nolisten", "tcp", pass_fds=[answer], stderr=subprocess.DEVNULL):
        os.close(answer)
        with os.fdopen(end) as number:
            yield f":{number.readline().strip()}"


def open_window(prefix, folder, environment):
    opens(prefix, folder, {**environment, "QT_QPA_PLATFORM": "offscreen"})
    print("the window opens without a screen")
    if not shutil.which("Xvfb"):
        print("skipped: Xvfb is not installed, so the window was not opened on a virtual display")
        return
    with virtual_display() as display:
        opens(prefix, folder, {**environment, "DISPLAY": display})
    print("the window opens on a virtual display")


def main():
    parser = argparse.ArgumentParser()
    for name in ("--cmake", "--build"):
        parser.add_argument(name, required=True)
    parser.add_argument("parts", nargs="+")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        prefix = install(arguments, folder)
        environment = environment_of_a_user(folder)
        check_libraries(prefix, environment)
        check_versions(prefix, environment)
        if "gui" in arguments.parts:
            open_window(prefix, folder, environment)


if __name__ == "__main__":
    main()
