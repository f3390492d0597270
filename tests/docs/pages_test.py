#!/usr/bin/env python3
"""pages_test.py ROOT BIN PAGE: checks that every command on a page of docs/ works, in the order of the page.

Runs the lines of the ```sh blocks with a separate GCM and separate folders for state and run-time files. Each line must
succeed. A program whose line ends with & runs until the page ends; the next line waits until it has started. A comment
in the page

    <!-- eventually: COMMAND => REGULAR EXPRESSION -->

names a command that is repeated until its output matches. Scripts of tools/ are not run, because this test runs after
they have done their work.
"""
import os
import pathlib
import re
import shlex
import signal
import subprocess
import sys
import tempfile
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
from free_port import free_port

TIMEOUT = 60  # s, for a machine that is busy
ALL_ACTIVE = r"\A(.*\tactive\t.*\n)+\Z"
STEP = re.compile(r"^```sh\n(?P<block>.*?)^```|^<!-- eventually: (?P<command>.*?) => (?P<pattern>.*?) -->", re.M | re.S)


class Place:
    """The environment in which the commands run. end() ends the programs that still run."""

    def __init__(self, root, programs, folder):
        self.root = root
        self.processes = []
        self.environment = {
            **os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "TENDON_GCM": f"127.0.0.1:{free_port()}",
            "XDG_STATE_HOME": folder, "XDG_RUNTIME_DIR": folder, "XDG_CONFIG_HOME": folder}

    def run(self, line):
        """Runs a line. A command that only shows something is repeated until it succeeds."""
        if re.match(r"gcm (--json )?(ls|tree|show|get|watch|status|find|graph|top|hz|plot|doctor|run|shell) ", line):
            return self.eventually(line, "")
        exported = re.match(r"export (\w+)=", line)
        if exported:
            self.environment[exported[1]] = self.run_once(f'{line}; printf %s "${exported[1]}"').stdout
        return self.run_once(line)

    def run_once(self, line):
        patient = re.sub(r"^gcm ", f"gcm --timeout {1000 * TIMEOUT} ", line)
        return subprocess.run(["sh", "-c", patient], cwd=self.root, env=self.environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=2 * TIMEOUT, check=False)

    def start(self, line):
        words = ["gcm", "serve"] if line.startswith("gcm-gui") else shlex.split(line)  # there is no screen
        if words[0] == "lcm":
            words += ["--timeout", str(1000 * TIMEOUT)]
        self.processes.append(subprocess.Popen(words, cwd=self.root, env=self.environment))
        listed = words[words.index("--name") + 1] if "--name" in words else ""
        self.eventually("gcm ls", f"^{listed}.*alive" if listed else "")
        if listed and "--system" in words:
            self.eventually(f"gcm ls {listed}", ALL_ACTIVE)

    def eventually(self, line, pattern):
        deadline = time.monotonic() + TIMEOUT
        while True:
            done = self.run_once(line)
            if done.returncode == 0 and re.search(pattern, done.stdout, re.M):
                return done
            if time.monotonic() > deadline:
                sys.exit(f"in {TIMEOUT} s '{line}' never printed {pattern!r}, but:\n{done.stdout}")
            time.sleep(0.2)

    def end(self):
        for process in reversed(self.processes):
            process.send_signal(signal.SIGTERM)
            try:
                process.wait(TIMEOUT)
            except subprocess.TimeoutExpired:
                process.kill()


def lines_of(block):
    """Yields the commands of a block. Joins continued lines, and removes comments."""
    for line in block.replace("\\\n", " ").splitlines():
        line = re.sub(r"(^|\s+)# .*", "", line).strip()
        line = line.replace("build/dev/bin/", "")
        if line and not line.startswith(("tools/", "export PATH=", "cmake ")):
            yield line


def steps_of(page):
    for found in STEP.finditer(page):
        if found["block"] is None:
            yield "eventually", found["command"], found["pattern"]
            continue
        for line in lines_of(found["block"]):
            yield ("start", line[:-1].strip()) if line.endswith("&") else ("run", line)


def main(root, programs, page):
    count = 0
    with tempfile.TemporaryDirectory() as folder:
        place = Place(root, programs, folder)
        try:
            for kind, *words in steps_of((pathlib.Path(root) / page).read_text(encoding="utf-8")):
                count += 1
                done = getattr(place, kind)(*words)
                if kind == "run" and done.returncode != 0:
                    sys.exit(f"{page}: '{words[0]}' ended with {done.returncode}:\n{done.stdout}")
        finally:
            place.end()
    print(f"{count} commands of {page} do what they should")
    return 0 if count else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
