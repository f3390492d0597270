"""system_test.py BIN ROOT: tests the package with a real GCM and the processes of the demo system."""
import contextlib
import io
import itertools
import json
import math
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

import tendon

PROGRAMS, ROOT = map(pathlib.Path, sys.argv[1:])
sys.path.append(str(ROOT / "tools"))
from free_port import free_port  # noqa: E402  pylint: disable=wrong-import-position

TIMEOUT = 60  # s, for a machine that is busy
GUEST = {"version": 1, "name": "guest", "processes": [{"name": "guest", "components": [
    {"name": "host_monitor", "class": "HostMonitor", "library": "host_monitor"}]}]}
TRACK = {"version": 1, "name": "track", "processes": [{"name": "track", "components": [
    {"name": "odometer", "class": "Odometer", "library": "odometer"}]}]}
ROBOT = "desk/teleoperation/Robot"
CONTROL = "robot/arm/Control"


class Place:
    """The environment in which the programs run. end() ends the programs that still run."""

    def __init__(self):
        self.folder = tempfile.TemporaryDirectory()
        self.address = f"127.0.0.1:{free_port()}"
        self.programs = []
        for name in ("XDG_STATE_HOME", "XDG_RUNTIME_DIR", "XDG_CONFIG_HOME"):
            os.environ[name] = self.folder.name
        os.environ["TENDON_GCM"] = self.address

    def start(self, program, *words):
        started = subprocess.Popen([PROGRAMS / program, *words])
        self.programs.append(started)
        return started

    def serve(self):
        return self.start("gcm", "serve")

    def run(self, process, system):
        return self.start("lcm", "--name", process, "--system", str(system), "--timeout",
                          str(1000 * TIMEOUT))

    def end(self):
        for program in reversed(self.programs):
            if program.poll() is None:
                program.terminate()
                try:
                    program.wait(TIMEOUT)
                except subprocess.TimeoutExpired:
                    program.kill()
                    program.wait()
        self.folder.cleanup()

    def connect(self):
        """Connects as soon as the GCM answers."""
        deadline = time.monotonic() + TIMEOUT
        while True:
            try:
                return tendon.connect(self.address, timeout=TIMEOUT)
            except (tendon.Unreachable, tendon.Denied):
                if time.monotonic() > deadline:
                    raise
                time.sleep(0.05)


def is_active(system, process, component):
    """True if the component is active."""
    known = [one["name"] for one in system.processes() if one["state"] == "alive"]
    return process in known and any(one["name"] == component and one["state"] == "active"
                                    for one in system.components(process))


def state_of(system, process):
    """The state of a process; None if the process is unknown."""
    return next((one["state"] for one in system.processes() if one["name"] == process), None)


class InTheDemoSystem(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = Place()
        cls.addClassCleanup(cls.place.end)
        cls.gcm = cls.place.serve()
        for process in ("robot", "desk"):
            cls.place.run(process, ROOT / "resources/systems/demo.json")
        cls.system = cls.place.connect()
        cls.addClassCleanup(cls.system.close)
        for process, component in (("robot", "arm"), ("robot", "host_monitor"),
                                   ("desk", "teleoperation"), ("desk", "supervisor"),
                                   ("desk", "old_arm")):
            cls.system.wait_until(
                lambda system, who=(process, component): is_active(system, *who), TIMEOUT)

    def connection(self, system):
        """The connection of teleoperation; None if there is none."""
        required = tendon.paths.parse_interface(ROBOT)
        return next((one for one in system.connections() if one["required"] == required), None)

    def test_processes_and_components_are_listed(self):
        robot = next(one for one in self.system.processes() if one["name"] == "robot")
        self.assertEqual(robot["state"], "alive")
        self.assertGreater(robot["pid"], 0)

        arm = next(one for one in self.system.components("robot") if one["name"] == "arm")
        self.assertEqual((arm["class_name"], arm["period"]), ("SimulatedArm", 0.001))
        control = next(one for one in arm["provided"] if one["name"] == "Control")
        move_to = next(one for one in control["commands"] if one["name"] == "MoveTo")
        self.assertEqual((move_to["signature"]["kind"], move_to["in_type"], move_to["hazard"]),
                         ("write", "arm.JointGoal", "motion"))

    def test_values_are_read(self):
        joints = self.system.read("robot/arm/Control.GetJoints")
        self.assertEqual(list(joints), ["position", "velocity"])
        self.assertEqual([len(part) for part in joints.values()], [7, 7])
        self.assertIsInstance(self.system.read("robot/arm/state.Joints.position[0]"), float)
        pose = self.system.read("robot/arm/Control.GetLinkPose", "base")
        self.assertEqual(self.system.read("robot/arm/Control.GetLinkPose.position.x", "base"),
                         pose["position"]["x"])

    def test_commands_are_executed(self):
        position = [0.2, -0.8, 0.0, -2.4, 0.0, 1.6, 0.8]
        self.assertIsNone(
            self.system.call("robot/arm/Control.MoveTo", {"position": position, "duration": 0.1}))

        with self.system.watch("robot/arm", ["Goal.position"], timeout=TIMEOUT) as rows:
            goal = next(row for row in rows if row["Goal.position"] == position)

        self.assertGreater(goal.tick, 0)
        self.assertIsNone(self.system.call("robot/arm/Control.Stop"))

    def test_every_row_arrives(self):
        with self.system.watch("robot/arm/state", timeout=TIMEOUT) as watch:
            rows = [next(watch) for _ in range(500)]
            lost = watch.lost_table + watch.lost_network + watch.lost_viewer

        self.assertLessEqual({"Joints", "Goal", "Refused"}, set(rows[0].values))
        self.assertEqual(list(rows[0]["Joints"]), ["position", "velocity"])
        self.assertEqual(rows[0]["Refused"], 0)
        gaps = sum(after.tick - before.tick - 1 for before, after in zip(rows, rows[1:]))
        self.assertTrue(all(before.tick < after.tick for before, after in zip(rows, rows[1:])))
        self.assertTrue(all(before.time < after.time for before, after in zip(rows, rows[1:])))
        self.assertLessEqual(gaps, lost)

    def test_a_period_limits_the_row_rate(self):
        with self.system.watch("robot/arm", ["Refused"], period=0.01, timeout=TIMEOUT) as rows:
            stretches = [next(rows).time // 10_000_000 for _ in range(20)]

        self.assertEqual(stretches, sorted(set(stretches)))

    def test_mistakes_are_explained(self):
        for kind, sentence, function, *arguments in [
                (tendon.NotFound, "no component 'robot/amr'; did you mean 'arm'?",
                 self.system.read, "robot/amr/state.Joints"),
                (tendon.Invalid, "robot/arm/Control.Stop is a void command, not a read: use call()",
                 self.system.read, "robot/arm/Control.Stop"),
                (tendon.Invalid, "robot/arm/Control.MoveTo needs an argument of arm.JointGoal",
                 self.system.call, "robot/arm/Control.MoveTo"),
                (tendon.Invalid, "robot/arm/Control.Stop takes no argument",
                 self.system.call, "robot/arm/Control.Stop", 1),
                (tendon.Invalid, "robot/arm/Control.MoveTo: position: expected a list of 7 float64 "
                 "(rad), got a list of 1", self.system.call, "robot/arm/Control.MoveTo",
                 {"position": [1.0], "duration": 1}),
                (tendon.NotFound, "there is no element [7]",
                 self.system.read, "robot/arm/state.Joints.position[7]"),
                (tendon.NotFound, "robot/arm has no column 'Joint'; did you mean 'Joints'?",
                 self.system.watch, "robot/arm", ["Joint"])]:
            with self.subTest(sentence=sentence):
                with self.assertRaises(kind) as caught:
                    function(*arguments)
                self.assertEqual(str(caught.exception), sentence)

    def test_interfaces_are_connected_and_disconnected(self):
        made = self.system.connect(ROBOT, CONTROL)
        self.assertEqual(made["provided"], tendon.paths.parse_interface(CONTROL))
        self.system.wait_until(
            lambda system: (self.connection(system) or {}).get("state") == "active", TIMEOUT)
        with self.assertRaisesRegex(tendon.Exists, f"^{ROBOT} is connected to {CONTROL} already"):
            self.system.connect(ROBOT, CONTROL)

        self.system.disconnect(ROBOT)

        self.assertIsNone(self.connection(self.system))
        with self.assertRaisesRegex(tendon.Failed, f"^{ROBOT} is not connected"):
            self.system.disconnect(ROBOT)
        with self.assertRaisesRegex(tendon.Incompatible, "old_arm"):
            self.system.connect(ROBOT, "desk/old_arm/Control")

    def test_numbers_beyond_doubles_are_exact(self):
        file = pathlib.Path(self.place.folder.name) / "track.json"
        file.write_text(json.dumps(TRACK), encoding="utf-8")
        self.place.run("track", file)
        self.system.wait_until(lambda system: is_active(system, "track", "odometer"), TIMEOUT)

        columns = ["Count", "Stamp", "Ready", "Mode"]
        with self.system.watch("track/odometer", columns, timeout=TIMEOUT) as rows:
            first, second = next(rows), next(rows)
        self.assertEqual(self.system.read("track/odometer/state.Last"), 2**64 - 1)
        self.assertGreater(first["Count"], 2**53)
        self.assertEqual(second["Count"] - first["Count"], second.tick - first.tick)
        self.assertEqual(first["Stamp"] % 10_000_000, 1)
        self.assertIsInstance(first["Ready"], bool)
        self.assertIn(first["Mode"], ("fault", "idle", "moving"))

        edges = self.system.read("track/odometer/state.Edges")
        self.assertEqual(math.copysign(1, edges["zero"]), -1)
        self.assertTrue(math.isnan(edges["none"]))
        self.assertEqual((edges["endless"], edges["largest"], edges["smallest"], edges["sum"]),
                         (-math.inf, sys.float_info.max, 5e-324, 0.1 + 0.2))

        self.system.call("track/odometer/Control.SetCount", 2**64 - 2**20 - 1)
        with self.system.watch("track/odometer", ["Count"], timeout=TIMEOUT) as rows:
            some = itertools.islice(rows, 1000)
            self.assertTrue(any(row["Count"] >= 2**64 - 2**20 - 1 for row in some))
        self.assertGreaterEqual(self.system.read("track/odometer/Control.GetCount"),
                                2**64 - 2**20 - 1)

    def test_a_killed_process_ends_its_watches_and_is_found_again(self):
        file = pathlib.Path(self.place.folder.name) / "guest.json"
        file.write_text(json.dumps(GUEST), encoding="utf-8")
        guest = self.place.run("guest", file)
        self.system.wait_until(lambda system: is_active(system, "guest", "host_monitor"), TIMEOUT)
        rows = self.system.watch("guest/host_monitor", timeout=TIMEOUT)
        next(rows)

        guest.send_signal(signal.SIGKILL)

        with self.assertRaises(tendon.Unreachable):
            for _ in rows:
                pass
        self.system.wait_until(lambda system: state_of(system, "guest") == "lost", TIMEOUT)
        with self.assertRaisesRegex(tendon.Failed, "^process 'guest' is lost"):
            self.system.watch("guest/host_monitor")

        self.place.run("guest", file)

        self.system.wait_until(lambda system: is_active(system, "guest", "host_monitor"), TIMEOUT)
        with self.system.watch("guest/host_monitor", timeout=TIMEOUT) as rows:
            next(rows)

    def test_data_flows_without_a_gcm_and_a_new_one_is_found(self):
        with self.system.watch("robot/arm", ["Refused"], timeout=TIMEOUT) as rows:
            next(rows)
            self.gcm.send_signal(signal.SIGKILL)
            self.gcm.wait()
            self.system.wait_until(lambda system: self.has_no_gcm(), TIMEOUT)
            before = next(rows).tick
            self.assertGreater(next(row.tick for row in rows if row.tick > before), before)
        self.assertEqual(len(self.system.read("robot/arm/state.Joints.position")), 7)

        type(self).gcm = self.place.serve()

        deadline = time.monotonic() + TIMEOUT
        while self.has_no_gcm():
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.05)
        for process in ("robot", "desk"):
            self.system.wait_until(
                lambda system, who=process: state_of(system, who) == "alive", TIMEOUT)

    def has_no_gcm(self):
        """True if a request fails because there is no GCM."""
        try:
            self.system.processes()
        except tendon.Unreachable as why:
            self.assertRegex(str(why), f"^no GCM at {self.place.address} .*start one with: gcm se")
            return True
        return False

    def test_other_users_are_refused(self):
        folder = pathlib.Path(self.place.folder.name)
        other = folder / "other" / "tendon"
        other.mkdir(parents=True)
        (other / "cookie").touch(mode=0o600)
        (other / "cookie").write_text("1", encoding="ascii")
        os.environ["XDG_RUNTIME_DIR"] = str(folder / "other")
        try:
            with self.assertRaisesRegex(tendon.Denied, "both must run as the same user"):
                tendon.connect(self.place.address, timeout=TIMEOUT)
        finally:
            os.environ["XDG_RUNTIME_DIR"] = str(folder)

    def test_a_silent_server_is_unreachable(self):
        with socket.create_server(("127.0.0.1", 0)) as mute:
            with self.assertRaisesRegex(tendon.Unreachable, "^no GCM at "):
                tendon.connect(f"127.0.0.1:{mute.getsockname()[1]}", timeout=0.2)

    def test_the_examples_of_the_readme_run(self):
        page = (ROOT / "resources/python/README.md").read_text(encoding="utf-8")
        examples = re.findall(r"^```python\n(.*?)^```", page, re.M | re.S)
        self.assertTrue(examples)
        names = {}
        recording = pathlib.Path(self.place.folder.name) / "run.mcap"
        goal = {"position": [0.0] * 7, "duration": 0.1}
        with subprocess.Popen([PROGRAMS / "gcm", "--timeout", str(1000 * TIMEOUT), "record",
                               "robot/**", "-o", recording, "--for", "1s"]) as recorder:
            while recorder.poll() is None:
                self.system.call("robot/arm/Control.MoveTo", goal)
        self.assertEqual(recorder.returncode, 0)
        for example in examples:
            patient = example.replace("connect()", f"connect(timeout={TIMEOUT})")
            patient = patient.replace("run.mcap", str(recording))
            patient = patient.replace("timeout=10", f"timeout={TIMEOUT}")
            printed = io.StringIO()
            with self.subTest(example=example), contextlib.redirect_stdout(printed):
                exec(patient, names)
            self.assertTrue(printed.getvalue() or "connect(" in example)

    def test_a_closed_system_ends_its_watches(self):
        with tendon.connect(self.place.address, timeout=TIMEOUT) as system:
            rows = system.watch("robot/arm", timeout=TIMEOUT)
            next(rows)
        with self.assertRaisesRegex(tendon.Unreachable, "^this program closed the connection$"):
            for _ in rows:
                pass
        for question in (system.processes, lambda: system.read("robot/arm/state.Joints")):
            with self.assertRaisesRegex(tendon.Failed, "this system is closed"):
                question()


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
