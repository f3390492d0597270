"""certified_test.py BIN ROOT: tests the package with a GCM and a process that require TLS."""
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

import tendon
from tendon.middleware.certificate import Shown, chosen_credentials, holder_of

PROGRAMS, ROOT = map(pathlib.Path, sys.argv[1:])
sys.path.append(str(ROOT / "tools"))
from free_port import free_port  # noqa: E402  pylint: disable=wrong-import-position

TIMEOUT = 60  # s, for a machine that is busy


class UnderTls(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        for name in ("XDG_STATE_HOME", "XDG_RUNTIME_DIR", "XDG_CONFIG_HOME"):
            os.environ[name] = folder.name
        for name in ("TENDON_CERTIFICATE", "TENDON_CA"):
            os.environ.pop(name, None)
        cls.address = f"127.0.0.1:{free_port()}"
        cls.cert("init")
        cls.processes = {name: cls.issue(name, "--role", "operator", "--process")
                         for name in ("gcm", "robot")}
        cls.anna = cls.issue("anna", "--role", "operator")
        cls.start("gcm", "serve", "--certificate", str(cls.processes["gcm"]))
        cls.start("lcm", "--name", "robot", "--system", str(ROOT / "resources/systems/demo.json"),
                  "--certificate", str(cls.processes["robot"]), "--timeout", str(1000 * TIMEOUT))

    @classmethod
    def cert(cls, *words):
        subprocess.run([PROGRAMS / "gcm", "cert", *words], check=True, stdout=subprocess.DEVNULL)

    @classmethod
    def issue(cls, name, *words):
        cls.cert("issue", name, *words, "--out", str(cls.folder))
        return cls.folder / f"{name}.crt"

    @classmethod
    def start(cls, program, *words):
        started = subprocess.Popen([PROGRAMS / program, "--gcm", cls.address, *words])
        cls.addClassCleanup(started.wait)
        cls.addClassCleanup(started.terminate)

    def connect(self, certificate):
        """Connects as soon as the GCM answers."""
        deadline = time.monotonic() + TIMEOUT
        while True:
            try:
                return tendon.connect(self.address, timeout=TIMEOUT, certificate=certificate)
            except tendon.Unreachable:
                if time.monotonic() > deadline:
                    raise
                time.sleep(0.05)

    def is_running(self, system):
        known = [one["name"] for one in system.processes() if one["state"] == "alive"]
        return "robot" in known and any(one["name"] == "arm" and one["state"] == "active"
                                        for one in system.components("robot"))

    def test_an_operator_reads_watches_and_commands(self):
        with self.connect(self.anna) as system:
            system.wait_until(self.is_running, TIMEOUT)
            self.assertEqual(len(system.read("robot/arm/state.Joints.position")), 7)
            self.assertIsNone(system.call("robot/arm/Control.Stop"))
            with system.watch("robot/arm", ["Refused"], timeout=TIMEOUT) as rows:
                self.assertGreater(next(rows).tick, 0)

    def test_a_viewer_reads_and_is_denied_commands(self):
        with self.connect(self.issue("vera", "--role", "viewer")) as system:
            system.wait_until(self.is_running, TIMEOUT)
            self.assertGreater(next(system.watch("robot/arm", timeout=TIMEOUT)).tick, 0)
            with self.assertRaisesRegex(tendon.Denied, "operator"):
                system.call("robot/arm/Control.Stop")

    def test_the_environment_names_the_certificate(self):
        os.environ["TENDON_CERTIFICATE"] = str(self.anna)
        try:
            with self.connect(None) as system:
                system.wait_until(self.is_running, TIMEOUT)
        finally:
            del os.environ["TENDON_CERTIFICATE"]

    def test_connecting_without_a_certificate_fails(self):
        self.connect(self.anna).close()  # the GCM answers
        with self.assertRaises(tendon.Error):
            tendon.connect(self.address, timeout=2)

    def test_a_process_is_not_accepted_as_the_gcm(self):
        with self.connect(self.anna) as system:
            system.wait_until(self.is_running, TIMEOUT)
            robot, = (one for one in system.processes() if one["name"] == "robot")
        with self.assertRaisesRegex(tendon.Unreachable, "is 'robot', but 'gcm' was expected"):
            tendon.connect(robot["address"], timeout=TIMEOUT, certificate=self.anna)

    def test_the_gcm_of_another_ca_is_not_trusted(self):
        elsewhere = self.folder / "elsewhere"
        subprocess.run([PROGRAMS / "gcm", "cert", "init"], check=True, stdout=subprocess.DEVNULL,
                       env={**os.environ, "TENDON_CA": str(elsewhere)})
        self.connect(self.anna).close()
        with self.assertRaisesRegex(tendon.Denied, "is not trusted"):
            tendon.connect(self.address, timeout=TIMEOUT, certificate=self.anna,
                           authority=elsewhere)

    def test_the_gcm_rejects_a_revoked_certificate(self):
        eve = self.issue("eve", "--role", "operator")
        self.connect(eve).close()
        self.cert("revoke", "eve")
        with self.assertRaises(tendon.Unreachable):
            tendon.connect(self.address, timeout=TIMEOUT, certificate=eve)

    def test_unusable_files_are_reported(self):
        with self.assertRaisesRegex(tendon.NotFound, "there is no .*nobody.crt"):
            tendon.connect(self.address, certificate=self.folder / "nobody.crt")
        careless = self.issue("careless", "--role", "viewer")
        careless.with_suffix(".key").chmod(0o644)
        with self.assertRaisesRegex(tendon.Denied, "chmod 600"):
            tendon.connect(self.address, certificate=careless)
        self.assertIsNone(chosen_credentials(None, None))
        for file in (careless, careless.with_suffix(".key")):
            careless.with_suffix(".key").chmod(0o600)
            content = file.read_bytes()
            file.write_bytes(b"nonsense")
            with self.subTest(file), self.assertRaisesRegex(tendon.Invalid, "cannot be used"):
                tendon.connect(self.address, certificate=careless)
            file.write_bytes(content)

    def test_a_certificate_names_its_holder(self):
        text = self.anna.read_text(encoding="ascii")
        self.assertEqual(holder_of(text), Shown("anna", "operator"))
        ca = self.folder / "tendon" / "ca" / "ca.crt"
        for nonsense in ("", "no certificate", text[:200], text.replace("M", "N", 3),
                         ca.read_text(encoding="ascii")):
            with self.subTest(nonsense), self.assertRaises(tendon.Invalid):
                holder_of(nonsense)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
