"""recorded_test.py BIN ROOT: compares recordings of `gcm record` with the files of `gcm export`."""
import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest
from decimal import Decimal

import numpy as np
import tendon

PROGRAMS, ROOT = map(pathlib.Path, sys.argv[1:])
sys.path.append(str(ROOT / "tools"))
from free_port import free_port  # noqa: E402  pylint: disable=wrong-import-position

TIMEOUT = 60  # s, for a machine that is busy
TRACK = """{"version": 1, "name": "track", "processes": [{"name": "track", "components": [
    {"name": "odometer", "class": "Odometer", "library": "odometer"}]}]}"""
TABLE = "track/odometer/state"
# Functions that read a cell of the CSV file, by the dtype of the column.
EXACT = {"f": float, "u": int, "i": int, "b": lambda cell: {"true": True, "false": False}[cell]}


def gcm(*words):
    """Runs gcm, and returns its output."""
    return subprocess.run([PROGRAMS / "gcm", "--timeout", str(1000 * TIMEOUT), *map(str, words)],
                          check=True, stdout=subprocess.PIPE, text=True).stdout


class Recorded(unittest.TestCase):
    """One recording for each compression."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        for name in ("XDG_STATE_HOME", "XDG_RUNTIME_DIR", "XDG_CONFIG_HOME"):
            os.environ[name] = folder.name
        os.environ["TENDON_GCM"] = f"127.0.0.1:{free_port()}"
        (cls.folder / "track.json").write_text(TRACK, encoding="utf-8")
        cls.start("gcm", "serve")
        cls.start("lcm", "--name", "track", "--system", str(cls.folder / "track.json"),
                  "--timeout", str(1000 * TIMEOUT))
        cls.wait_for_rows()
        for compression in ("zstd", "lz4", "none"):
            gcm("record", "**", "-o", cls.folder / f"{compression}.mcap", "--for", "1s",
                "--compression", compression)

    @classmethod
    def start(cls, program, *words):
        started = subprocess.Popen([PROGRAMS / program, *words])
        cls.addClassCleanup(started.wait)
        cls.addClassCleanup(started.terminate)

    @classmethod
    def wait_for_rows(cls):
        deadline = time.monotonic() + TIMEOUT
        while True:
            try:
                return gcm("get", f"{TABLE}.Count")
            except subprocess.CalledProcessError:
                if time.monotonic() > deadline:
                    raise
                time.sleep(0.05)

    def test_every_number_is_that_of_the_csv_file(self):
        for compression in ("zstd", "lz4", "none"):
            folder = self.folder / f"{compression}.csv"
            gcm("export", self.folder / f"{compression}.mcap", "--csv", folder)
            with open(folder / "track.odometer.state.csv", encoding="utf-8", newline="") as file:
                rows = [row for row in csv.DictReader(file) if row["lost"] == "0"]
            self.assertGreater(len(rows), 10)
            with self.subTest(compression=compression), \
                    tendon.open(self.folder / f"{compression}.mcap") as run:
                self.assertEqual(run.problems, [])
                self.assertEqual(run.times(TABLE).tolist(), [int(row["time_ns"]) for row in rows])
                self.assertEqual(run.source_times(TABLE).tolist(),
                                 [int(row["source_time_ns"]) for row in rows])
                self.assertEqual((run.ticks(TABLE) % 2**32).tolist(),
                                 [int(row["sequence"]) for row in rows])
                columns = [name for name in rows[0] if name[0].isupper()]
                self.assertLess(10, len(columns))
                for column in columns:
                    self.compare(run, column, [row[column] for row in rows])

    def compare(self, run, column, cells):
        path = f"{TABLE}.{column}"
        values = run[path]
        if column.endswith("uptime"):  # the CSV file has seconds
            values = values.astype("i8")
            cells = [str(round(Decimal(cell) * 10**9)) for cell in cells]
        if column == "Mode":
            names = run.enumerators(path)
            self.assertEqual([names[value] for value in values.tolist()], cells)
            return
        expected = np.array([EXACT[values.dtype.kind](cell) for cell in cells], values.dtype)
        np.testing.assert_array_equal(values, expected, f"{path} {values.dtype}")

    def test_a_recording_describes_itself(self):
        with tendon.open(self.folder / "zstd.mcap") as run:
            self.assertIn(TABLE, run.tables())
            self.assertEqual(run.unit(f"{TABLE}.Edges.sum"), "m")
            self.assertEqual(run[f"{TABLE}.Count"].dtype, "u8")
            self.assertEqual(run.about["paths"], "**")
            self.assertEqual(int(run.about["rows_lost_recorder"]), 0)
            self.assertIn(b"Odometer", run.attachment("system.json"))
            self.assertEqual(int(run.about["log_records"]), len(run.log))

    def test_a_recording_without_its_end_is_read_up_to_there(self):
        content = (self.folder / "none.mcap").read_bytes()
        broken = self.folder / "broken.mcap"
        broken.write_bytes(content[:-100])

        with self.assertWarnsRegex(tendon.DamagedRecording, "cut off"):
            run = tendon.open(broken)
        self.addCleanup(run.close)

        with tendon.open(self.folder / "none.mcap") as whole:
            np.testing.assert_array_equal(run[f"{TABLE}.Count"], whole[f"{TABLE}.Count"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
