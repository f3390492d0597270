"""What the tests of the installation share: they install into a temporary folder, move it, and run its programs."""

import contextlib
import os
import subprocess
import sys
import time
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "tools"))
from free_port import free_port  # noqa: F401

TIMEOUT = 60  # s, for a machine that is busy


def run(*command, **options):
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\nended with {done.returncode}:\n{done.stdout[-4000:]}")
    return done.stdout


def install(arguments, folder):
    """Installs the parts below `folder`, and returns the folder to which it then moves them."""
    first, prefix = folder / "first place", folder / "prefix"
    for part in arguments.parts:
        run(arguments.cmake, "--install", arguments.build, "--prefix", first, "--component", part)
    first.rename(prefix)
    return prefix


def environment_of_a_user(folder, **more):
    """Without the paths of this machine's builds: installed programs must find their files by themselves."""
    mine = ("LD_LIBRARY_PATH", "LD_PRELOAD", "TENDON_COMPONENTS", "TENDON_GCM", "QT_QPA_PLATFORM", "DISPLAY",
            "WAYLAND_DISPLAY")
    environment = {name: value for name, value in os.environ.items() if name not in mine}
    own = {"HOME": folder, "XDG_CONFIG_HOME": folder, "XDG_CACHE_HOME": folder, "XDG_STATE_HOME": folder,
           "XDG_RUNTIME_DIR": folder}
    return {**environment, **{name: str(value) for name, value in {**own, **more}.items()}}


@contextlib.contextmanager
def running(*command, **options):
    """Runs a program until the end of the block. Its output goes to the output of this test."""
    process = subprocess.Popen(command, **options)
    try:
        yield process
    finally:
        process.terminate()
        process.wait(TIMEOUT)


def wait_for(what, succeeds, *processes):
    deadline = time.monotonic() + TIMEOUT
    while not succeeds():
        ended = [str(process.args[0]) for process in processes if process.poll() is not None]
        if ended or time.monotonic() > deadline:
            sys.exit(f"{what} did not appear within {TIMEOUT} s; programs that ended: {ended}")
        time.sleep(0.1)
