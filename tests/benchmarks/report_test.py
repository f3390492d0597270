"""Runs every case of the report for as short a time as possible, and checks the output. Does not judge the times."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""
IDS = ["Q1", "D1", "D3", "D4", "D5", "S1", "S2", "S3", "S4", "P1", "P1-p99", "P4",
       "W-rec", "W-zstd", "W-open", "W-seek", "W-mem"]
NETWORK_IDS = ["R1", "R1-one", "R7", "R7-filled", "R7-copy", "R3", "R4", "R2", "R5", "R8-zmq", "R8-dds", "R6",
               "R6-row", "R9", "R9-con", "T1", "T1-con", "G1", "G2", "G3", "W-load", "W-lost",
               "W-flat", "W-size"]
WINDOW_IDS = ["V1", "V2", "V1-noi", "V2-noi", "V1-new", "V2-new", "V1-nn", "V2-nn", "W1", "W2", "W3"]
TIMEOUT = 240  # s, for a sanitizer on a busy machine
KEYS = {"id", "ours", "floor", "ratio", "gate", "stretch", "holds"}


def run(*arguments):
    return subprocess.run([PROGRAM, "--tiny", *arguments], capture_output=True, text=True, timeout=TIMEOUT)


def entries(*arguments):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "report.json"
        finished = run("--json", str(path), *arguments)
        assert finished.returncode == 0, finished.stderr
        # The cases log nothing to stderr, and use the functions of Ice that tendon_ice replaces.
        assert " joined the GCM " not in finished.stderr, finished.stderr
        assert "does not check the sizes" not in finished.stderr, finished.stderr
        return finished.stdout, json.loads(path.read_text())


class Report(unittest.TestCase):
    def test_every_case_runs_and_has_an_entry(self):
        table, report = entries()
        self.assertEqual([entry["id"] for entry in report], IDS)
        self.assertEqual(len(table.splitlines()), 1 + len(IDS))
        for entry in report:
            self.assertLessEqual(KEYS, entry.keys())
            if entry["ratio"] is not None and entry["gate"] is not None:
                self.assertIn(entry["holds"], (True, False))

    def test_only_the_requested_cases_run(self):
        _, report = entries("--only", "S4,Q1")
        self.assertEqual([entry["id"] for entry in report], ["Q1", "S4"])

    def test_an_unknown_case_lists_the_known_ones(self):
        finished = run("--only", "S4,X9")
        self.assertEqual(finished.returncode, 2)
        self.assertIn("there is no case 'X9'; there are Q1, D1", finished.stderr)

    def test_an_unwritable_file_fails_before_measuring(self):
        for path in ("/no/such/folder/report.json", ""):
            finished = run("--only", "S1", "--json", path)
            self.assertEqual(finished.returncode, 1)
            self.assertIn(f"cannot write '{path}'", finished.stderr)
            self.assertEqual(finished.stdout, "")

    def test_a_queued_command_makes_no_system_call(self):
        _, (entry,) = entries("--only", "D4")
        if entry["ours"] is None:
            self.skipTest("this kernel does not let a program watch its system calls")
        self.assertEqual(entry["ours"], 0)

    def test_remote_cases_are_measured_with_their_floor(self):
        if "R1" not in IDS:
            self.skipTest("there is no Ice to compare with")
        _, report = entries("--only", "R1,R3,R7")
        for entry in report:
            self.assertGreater(entry["floor"], 0)
            self.assertGreater(entry["ours"], 0)

    def test_plots_are_measured_with_stock_qwt(self):
        if "V1" not in IDS:
            self.skipTest("there is no window to measure")
        _, report = entries("--only", "V1,V2")
        for entry in report:
            self.assertGreater(entry["floor"], 0)
            self.assertGreater(entry["ours"], 0)

    def test_further_connections_need_no_threads(self):
        if "T1" not in IDS:
            self.skipTest("there is no Ice to compare with")
        _, report = entries("--only", "T1,T1-con")
        idle, further = (entry["ours"] for entry in report)
        self.assertTrue(0 < idle <= 12, idle)
        self.assertLess(further, 1)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    sys.argv = [word for word in sys.argv if word]  # a part that is not built is an empty word
    for kind, ids in (("with-network", NETWORK_IDS), ("with-window", WINDOW_IDS)):
        if kind in sys.argv:
            sys.argv.remove(kind)
            IDS += ids
    unittest.main()
