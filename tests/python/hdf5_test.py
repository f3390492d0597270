"""hdf5_test.py GCM: reads files of `gcm export --hdf5` with h5py."""
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np
import tendon
from handmade_recording import WHEEL, Writer
from tendon.payload.schema_text import parse

GCM = sys.argv[1]
MS = 1_000_000  # ns
NOTE = parse("struct cart.Note {\n  text: string\n  words: string[2]\n  path: int16[]\n"
             "  speed: float32 in m/s\n}")
LEGS = [{"load": -7, "force": [1.0, 2.0, 3.0]}, {"load": 8, "force": [4.0, 5.0, 6.0]}]


class Exported(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.recording = self.folder / "run.mcap"
        self.output = self.folder / "run.h5"

    def export(self, *words, code=0, **options):
        """Runs `gcm export`, and returns its messages."""
        done = subprocess.run([GCM, "export", self.recording, "--hdf5", self.output, *words],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              check=False, **options)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stderr

    def opened(self, writer, *words, code=0):
        """Exports the recording of a writer, and opens the HDF5 file."""
        writer.save(self.recording)
        self.export(*words, code=code)
        file = h5py.File(self.output)
        self.addCleanup(file.close)
        return file

    def counting(self, ticks, epoch=1, begin=0, writer=None):
        writer = writer or Writer()
        channel = writer.channel("robot/cart/state.Count", "uint64", epoch=epoch, clock=50)
        for tick in ticks:
            writer.message(channel, tick % 2**32, begin + MS * tick + epoch, parse("uint64").encode(tick))
        return writer

    def test_every_column_is_that_of_the_recording(self):
        writer, schema = Writer(), parse(WHEEL)
        channel = writer.channel("robot/cart/state.Wheel", WHEEL)
        for row in range(20_000):  # more than one chunk of the dataset
            writer.message(channel, row, row, schema.encode(
                {"speed": row / 7, "mode": "moving" if row % 2 else "idle", "uptime": row / 8,
                 "ready": row % 3 == 0, "legs": LEGS}))
            if row % 5000 == 4999:
                writer.chunk()
        file = self.opened(writer)
        wheel = file["robot/cart/state/Wheel"]

        with tendon.open(self.recording) as run:
            for name in ("speed", "mode", "ready"):
                expected = run[f"robot/cart/state.Wheel.{name}"]
                self.assertEqual(wheel[name].dtype,
                                 expected.dtype if name != "ready" else np.uint8)
                np.testing.assert_array_equal(wheel[name][:], expected)
            np.testing.assert_array_equal(
                wheel["uptime"][:], run["robot/cart/state.Wheel.uptime"].astype("i8"))
            legs = run["robot/cart/state.Wheel.legs"]
            np.testing.assert_array_equal(wheel["legs/force"][:], legs["force"])
            np.testing.assert_array_equal(wheel["legs/load"][:], legs["load"])
            np.testing.assert_array_equal(file["robot/cart/state/time_ns"][:],
                                          run.times("robot/cart/state"))
        self.assertEqual(wheel["legs/force"].shape, (20_000, 2, 3))
        self.assertEqual((wheel["speed"].compression, wheel["speed"].shuffle), ("gzip", True))

    def test_units_and_enumerators_are_attributes(self):
        writer = Writer()
        channel = writer.channel("robot/cart/state.Wheel", WHEEL)
        writer.message(channel, 0, 0, parse(WHEEL).encode(
            {"speed": 1.0, "mode": "moving", "uptime": 0.0, "ready": True, "legs": LEGS}))
        wheel = self.opened(writer)["robot/cart/state/Wheel"]

        self.assertEqual(wheel["speed"].attrs["unit"], "rad/s")
        self.assertEqual(wheel["legs/force"].attrs["unit"], "N")
        self.assertEqual(wheel["uptime"].attrs["unit"], "ns")
        self.assertEqual(wheel["mode"].attrs["names"].tolist(), ["idle", "moving"])
        self.assertEqual(wheel["mode"].attrs["values"].tolist(), [0, 7])
        self.assertEqual(wheel["ready"].attrs["names"].tolist(), ["false", "true"])

    def test_text_is_utf_8_and_sequences_are_json(self):
        writer = Writer()
        channel = writer.channel("robot/cart/state.Note", NOTE.text())
        for row, text in enumerate(("", "größer 🚗")):
            writer.message(channel, row, row, NOTE.encode(
                {"text": text, "words": ["a", text], "path": [row] * row, "speed": 0.5}))
        table = self.opened(writer)["robot/cart/state"]

        self.assertEqual(table["Note/text"].asstr()[:].tolist(), ["", "größer 🚗"])
        self.assertEqual(table["Note/words"].asstr()[:].tolist(), [["a", ""], ["a", "größer 🚗"]])
        self.assertEqual(table["Note/speed"][:].tolist(), [0.5, 0.5])
        self.assertNotIn("path", table["Note"])
        self.assertIn('"path":[1]', table["Note.json"].asstr()[1])

    def test_gaps_and_restarts_are_told(self):
        writer = self.counting([2**32 - 2, 2**32 - 1, 2**32 + 2])
        begin = MS * 2**33
        self.counting([0, 1], epoch=2, begin=begin, writer=writer)
        table = self.opened(writer)["robot/cart/state"]

        self.assertEqual(table["tick"][:].tolist(), [2**32 - 2, 2**32 - 1, 2**32 + 2, 0, 1])
        self.assertEqual(table["starts"][:].tolist(), [0, 3])
        self.assertEqual({name: values[:].tolist() for name, values in table["gaps"].items()},
                         {"row": [2], "missing": [2], "begin_ns": [MS * (2**32 - 1) + 1],
                          "end_ns": [MS * (2**32 + 2) + 1]})
        self.assertEqual(table["source_time_ns"][3:].tolist(), [begin + 2 - 50, begin + MS + 2 - 50])

    def test_events_and_other_topics_are_groups(self):
        writer = Writer()
        passed = writer.channel("robot/cart/Control.Passed", "float64", "event")
        stopped = writer.channel("robot/cart/Control.Stopped", "struct tendon.None {\n}", "event")
        lap = parse("struct cart.Lap {\n  sequence: int32\n  time_ns: int64\n}")
        timed = writer.channel("robot/cart/Control.Timed", lap.text(), "event")
        writer.message(timed, 0, 9, lap.encode({"sequence": 3, "time_ns": 4}))
        writer.message(passed, 0, 7, parse("float64").encode(1.5))
        writer.message(stopped, 0, 8, b"\0")
        file = self.opened(writer)

        self.assertEqual(file["robot/cart/Control/Passed/value"][:].tolist(), [1.5])
        self.assertEqual(file["robot/cart/Control/Timed/value/sequence"][:].tolist(), [3])
        self.assertEqual(file["robot/cart/Control/Stopped/time_ns"][:].tolist(), [8])

    def test_only_the_chosen_part_is_written(self):
        table = self.opened(self.counting(range(10)), "--from", "2ms", "--to", "5ms",
                            "--paths", "robot/cart")["robot/cart/state"]
        self.assertEqual(table["Count"][:].tolist(), [2, 3, 4])

    def test_an_incomplete_row_is_left_out_and_counted(self):
        writer = Writer()
        count = writer.channel("robot/cart/state.Count", "uint64")
        double = writer.channel("robot/cart/state.Double", "uint64")
        for row in range(4):
            for channel in (count, double)[:1 if row == 2 else 2]:
                writer.message(channel, row, row, parse("uint64").encode(row))
        writer.save(self.recording)

        self.assertIn("1 entry is left out, because a part of the file is missing or malformed", self.export())

        with h5py.File(self.output) as file:
            self.assertEqual(file["robot/cart/state/Double"][:].tolist(), [0, 1, 3])

    def test_a_type_that_changed_gets_a_second_group(self):
        writer = self.counting([1])
        channel = writer.channel("robot/cart/state.Count", "float64", epoch=2)
        writer.message(channel, 0, 5000, parse("float64").encode(0.5))
        file = self.opened(writer)

        self.assertEqual(file["robot/cart/state/Count"][:].tolist(), [1])
        self.assertEqual(file["robot/cart/state-2/Count"][:].tolist(), [0.5])

    def test_names_of_other_programs_are_only_names(self):
        writer = Writer()
        for topic in ("/a/../b", "./x//y", "time_ns"):
            channel = writer.channel("", "float64", "other", topic=topic)
            writer.message(channel, 0, 0, parse("float64").encode(0.5))
        column = writer.channel("robot/cart/state.tick", "float64")
        writer.message(column, 0, 0, parse("float64").encode(0.5))
        file = self.opened(writer)

        self.assertEqual(set(file), {"a", "_", "time_ns", "robot"})
        self.assertEqual(file["robot/cart/state/tick_"][:].tolist(), [0.5])

    def test_a_damaged_recording_is_exported_as_far_as_it_can_be_read(self):
        writer = self.counting(range(5))
        writer.chunk()
        self.counting(range(7, 9), writer=writer)
        content = bytearray(writer.finish())
        content[writer.chunk_starts[0] + 300] ^= 1
        self.recording.write_bytes(content)

        self.assertIn("is skipped: ", self.export(code=8))

        with h5py.File(self.output) as file:
            self.assertEqual(file["robot/cart/state/Count"][:].tolist(), [7, 8])

    def test_no_file_is_replaced(self):
        self.counting(range(3)).save(self.recording)
        self.output.write_text("mine", encoding="ascii")
        self.assertIn("no file is replaced", self.export(code=1))
        self.assertEqual(self.output.read_text(encoding="ascii"), "mine")

    def test_a_full_disk_leaves_no_file(self):
        rows = np.random.default_rng(1).bytes(8 * 200_000)  # random bytes cannot be compressed
        writer = Writer()
        channel = writer.channel("robot/cart/state.Count", "uint64")
        for row in range(200_000):
            writer.message(channel, row, row, rows[8 * row:8 * row + 8])
        writer.save(self.recording)

        for size in (512 << 10, 100):  # the disk is full within the rows, or at the beginning
            def limit(most=size):
                """Beyond this size, writing fails with "File too large"."""
                signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
                resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))

            with self.subTest(size=size):
                why = self.export(code=1, preexec_fn=limit)
                self.assertRegex(why, "^gcm: cannot write .*run.h5: File too large; no file was "
                                      "written\n$")
                self.assertEqual([path.name for path in self.folder.iterdir()], ["run.mcap"])

    def test_one_of_two_formats_must_be_chosen(self):
        self.counting(range(3)).save(self.recording)
        self.assertIn("give either --csv FOLDER or --hdf5 FILE.h5", self.export("--csv", self.folder / "csv", code=2))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
