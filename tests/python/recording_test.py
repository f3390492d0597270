"""Tests recordings as arrays: values, rows, and damaged files."""
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import warnings
from unittest import mock

import lz4.frame
import numpy as np
import tendon
import zstandard
from handmade_recording import WHEEL, Writer
from tendon.payload import arrays
from tendon.payload.ros_text import parse_message
from tendon.payload.schema_text import parse

WHEELS = [{"speed": 0.1 + 0.2, "mode": "moving", "uptime": 2.000000001, "ready": True,
           "legs": [{"load": -7, "force": [1.0, 2.0, 3.0]}, {"load": 8, "force": [4, 5, 6]}]},
          {"speed": -0.0, "mode": "idle", "uptime": -0.5, "ready": False,
           "legs": [{"load": 0, "force": [0.0, 0.0, 0.0]}, {"load": 1, "force": [-1, -2, -3]}]}]


def number(value):
    return struct.pack("<Q", value)


class OnFile(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "run.mcap"

    def open(self, content, problems=None):
        """Opens a recording, and checks that opening it reports this number of problems."""
        self.path.write_bytes(content)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            recording = tendon.open(self.path)
        self.addCleanup(recording.close)
        self.assertEqual(len(caught), problems or 0, [str(one.message) for one in caught])
        return recording


def counting(rows, chunk=0, compress=None, epoch=1):
    """Writes rows with two columns: Count, and Double with twice the value."""
    writer = Writer(compress) if compress else Writer()
    count = writer.channel("robot/cart/state.Count", "uint64", epoch=epoch)
    double = writer.channel("robot/cart/state.Double", "uint64", epoch=epoch)
    for row in range(rows):
        writer.message(count, row, 1000 * row, number(row))
        writer.message(double, row, 1000 * row, number(2 * row))
        if chunk and row % chunk == chunk - 1:
            writer.chunk()
    return writer


class Values(OnFile):
    def wheels(self):
        writer = Writer()
        schema = parse(WHEEL)
        channel = writer.channel("robot/cart/state.Wheel", WHEEL)
        for row, wheel in enumerate(WHEELS):
            writer.message(channel, row, row, schema.encode(wheel))
        return self.open(writer.finish())

    def test_numbers_keep_their_type_and_all_digits(self):
        for kind, dtype, values in (("uint64", "u8", [2**64 - 1, 2**53 + 1]),
                                    ("int8", "i1", [-128, 127]), ("float32", "f4", [0.1, -1.5]),
                                    ("float64", "f8", [0.1 + 0.2, 5e-324])):
            with self.subTest(kind=kind):
                writer = Writer()
                channel = writer.channel("robot/cart/state.Value", kind)
                for row, value in enumerate(values):
                    writer.message(channel, row, row, parse(kind).encode(value))

                found = self.open(writer.finish())["robot/cart/state.Value"]

                self.assertEqual(found.dtype, dtype)
                self.assertEqual(found.tolist(), np.array(values, dtype).tolist())

    def test_a_field_is_an_array_with_a_row_for_each_message(self):
        run = self.wheels()

        self.assertEqual(run["robot/cart/state.Wheel.speed"].tolist(), [0.1 + 0.2, -0.0])
        self.assertEqual(run["robot/cart/state.Wheel.mode"].tolist(), [7, 0])
        self.assertEqual(run["robot/cart/state.Wheel.ready"].tolist(), [True, False])
        force = run["robot/cart/state.Wheel.legs[1].force"]
        self.assertEqual(force.tolist(), [[4, 5, 6], [-1, -2, -3]])
        self.assertEqual(run["robot/cart/state.Wheel.legs[1].force[2]"].tolist(), [6, -3])

    def test_durations_are_exact(self):
        uptime = self.wheels()["robot/cart/state.Wheel.uptime"]

        self.assertEqual(uptime.dtype, "m8[ns]")
        self.assertEqual(uptime.astype("i8").tolist(), [2_000_000_001, -500_000_000])

    def test_a_structure_is_a_structured_array(self):
        wheel = self.wheels()["robot/cart/state.Wheel"]

        self.assertEqual(wheel.dtype.names, ("speed", "mode", "uptime", "ready", "legs"))
        self.assertEqual(wheel["legs"]["load"].tolist(), [[-7, 8], [0, 1]])
        self.assertEqual(wheel["legs"]["force"].shape, (2, 2, 3))

    def test_fast_and_slow_decoding_agree(self):
        schema = parse(WHEEL)
        bodies = [schema.encode(wheel) for wheel in WHEELS]
        self.assertTrue(arrays.is_vectorised(schema, ""))

        fast = arrays.decode_fixed(np.frombuffer(b"".join(bodies), np.uint8).reshape(2, -1), schema,
                                   "")

        self.assertEqual(fast.tobytes(), arrays.decode_each(bodies, schema, "").tobytes())

    def test_elements_of_one_array_may_be_aligned_differently(self):
        schema = parse("struct t.T {\n  a: struct t.S {\n    x: int8\n    y: int32\n    z: int8\n"
                       "  }[3]\n  after: int64\n}")
        value = {"a": [{"x": i, "y": 10 * i, "z": -i} for i in range(3)], "after": 9}
        body = np.frombuffer(schema.encode(value), np.uint8).reshape(1, -1)

        found = arrays.decode_fixed(body, schema, "")

        self.assertEqual(found["a"]["y"].tolist(), [[0, 10, 20]])
        self.assertEqual(found["a"]["z"].tolist(), [[0, -1, -2]])
        self.assertEqual(arrays.decode_fixed(body, schema, ".after").tolist(), [9])
        self.assertEqual(arrays.decode_fixed(body, schema, ".a[2].y").tolist(), [20])

    def test_text_and_sequences_are_objects(self):
        schema = parse("struct t.Note {\n  speed: float64 in m/s\n  text: string\n"
                       "  path: int16[]\n}")
        writer = Writer()
        channel = writer.channel("robot/cart/state.Note", schema.text())
        for row, text in enumerate(("one", "é" * 5)):
            writer.message(channel, row, row, schema.encode(
                {"speed": row / 2, "text": text, "path": [row] * row}))
        run = self.open(writer.finish())

        self.assertEqual(run["robot/cart/state.Note.text"].tolist(), ["one", "ééééé"])
        self.assertEqual(run["robot/cart/state.Note.path"].tolist(), [[], [1]])
        speed = run["robot/cart/state.Note.speed"]
        self.assertEqual((speed.dtype, speed.tolist()), ("f8", [0, 0.5]))
        self.assertEqual(run["robot/cart/state.Note"][1]["text"], "ééééé")

    def test_units_and_enumerators_are_told(self):
        run = self.wheels()

        self.assertEqual(run.units(), {"robot/cart/state.Wheel.speed": "rad/s"})
        self.assertEqual(run.unit("robot/cart/state.Wheel.legs[0].force"), "N")
        self.assertEqual(run.enumerators("robot/cart/state.Wheel.mode"), {0: "idle", 7: "moving"})
        self.assertEqual(run.paths(), [f"robot/cart/state.Wheel.{field}" for field in
                                       ("legs", "mode", "ready", "speed", "uptime")])

    def test_malformed_values_are_refused_with_their_path(self):
        for body, why in ((b"\2", "a bool other than 0 and 1"), (b"", "does not have the 1 bytes"),
                          (bytes(9), "does not have the 1 bytes")):
            with self.subTest(body=body):
                writer = Writer()
                channel = writer.channel("robot/cart/state.Ready", "bool")
                writer.message(channel, 0, 0, body)
                with self.assertRaisesRegex(tendon.Invalid, "^robot/cart/state.Ready in .*" + why):
                    self.open(writer.finish())["robot/cart/state.Ready"]

    def test_unknown_paths_suggest_known_ones(self):
        run = self.wheels()
        for path, hint in (("robot/cart/state.Whel", "did you mean 'robot/cart/state.Wheel'"),
                           ("robot/cart/state", "name a column of it"),
                           ("robot/cart/state.Wheel.sped", "did you mean 'speed'"),
                           ("robot/cart/state.Wheel.legs[2]", r"no element \[2\]")):
            with self.subTest(path=path), self.assertRaisesRegex(tendon.NotFound, hint):
                run[path]


class Rows(OnFile):
    def test_times_and_ticks_belong_to_the_values(self):
        run = self.open(counting(2500, chunk=1000).finish())

        self.assertEqual(run["robot/cart/state.Double"].tolist(), list(range(0, 5000, 2)))
        self.assertEqual(run.times("robot/cart/state").tolist(), list(range(0, 2_500_000, 1000)))
        self.assertEqual(run.times("robot/cart/state.Count").dtype, "i8")
        self.assertEqual(run.ticks("robot/cart/state").tolist(), list(range(2500)))
        self.assertEqual(len(run.gaps("robot/cart/state")), 0)

    def test_ticks_go_on_beyond_32_bits(self):
        writer = Writer()
        channel = writer.channel("robot/cart/state.Count", "uint64")
        for row in range(4):
            writer.message(channel, (2**32 - 2 + row) % 2**32, row, number(row))

        ticks = self.open(writer.finish()).ticks("robot/cart/state")

        self.assertEqual(ticks.tolist(), [2**32 - 2, 2**32 - 1, 2**32, 2**32 + 1])

    def test_missing_rows_are_gaps(self):
        writer = Writer()
        channel = writer.channel("robot/cart/state.Count", "uint64")
        for tick in (5, 6, 10, 11):
            writer.message(channel, tick, 100 * tick, number(tick))

        gaps = self.open(writer.finish()).gaps("robot/cart/state")

        self.assertEqual(gaps.tolist(), [(2, 600, 1000, 3)])

    def test_a_restart_of_the_process_is_no_gap(self):
        writer = Writer()
        for epoch in (1, 2):
            channel = writer.channel("robot/cart/state.Count", "uint64", epoch=epoch)
            for tick in range(3):
                writer.message(channel, tick, 1000 * epoch + tick, number(10 * epoch + tick))

        run = self.open(writer.finish())

        self.assertEqual(run["robot/cart/state.Count"].tolist(), [10, 11, 12, 20, 21, 22])
        self.assertEqual(run.ticks("robot/cart/state").tolist(), [0, 1, 2] * 2)
        self.assertEqual(run.starts("robot/cart/state").tolist(), [0, 3])
        self.assertEqual(len(run.gaps("robot/cart/state")), 0)

    def test_a_type_that_changed_is_refused(self):
        writer = Writer()
        for epoch, kind in ((1, "uint64"), (2, "float64")):
            channel = writer.channel("robot/cart/state.Count", kind, epoch=epoch)
            writer.message(channel, 0, epoch, number(0))
        with self.assertRaisesRegex(tendon.Invalid, "several types in .*gcm cut"):
            self.open(writer.finish())["robot/cart/state.Count"]

    def test_the_clock_of_the_source_is_kept(self):
        writer = Writer()
        channel = writer.channel("robot/cart/state.Count", "uint64", clock=400)
        writer.message(channel, 0, 1000, number(0), source_time=900)

        run = self.open(writer.finish())

        self.assertEqual(run.source_times("robot/cart/state").tolist(), [500])

    def test_a_clock_that_is_no_number_of_64_bits_counts_as_zero(self):
        for clock in ("12345678901234567890", "-12345678901234567890", "noon"):
            writer = Writer()
            channel = writer.channel("robot/cart/state.Count", "uint64", clock=clock)
            writer.message(channel, 0, 1000, number(0), source_time=900)

            run = self.open(writer.finish())

            self.assertEqual(run.source_times("robot/cart/state").tolist(), [900])

    def test_events_log_and_losses_are_read(self):
        writer = Writer()
        stopped = writer.channel("robot/cart/Control.Stopped", "struct tendon.None {\n}", "event")
        passed = writer.channel("robot/cart/Control.Passed", "float64", "event")
        log_schema = parse("struct rcl_interfaces.Log {\n  stamp: duration\n  level: uint8\n"
                           "  name: string\n  msg: string\n}")
        loss_schema = parse("struct tendon.Loss {\n  path: string\n  table: uint64\n"
                            "  network: uint64\n  recorder: uint64\n}")
        log = writer.channel("", log_schema.text(), "other", topic="rosout")
        lost = writer.channel("", loss_schema.text(), "other", topic="tendon/lost")
        writer.message(stopped, 0, 5, b"\0")
        writer.message(passed, 0, 6, parse("float64").encode(1.5))
        for time, text in ((9, "later"), (7, "earlier")):
            writer.message(log, 0, time, log_schema.encode(
                {"stamp": 0.0, "level": 30, "name": "robot/cart", "msg": text}))
        writer.message(lost, 0, 8, loss_schema.encode(
            {"path": "robot/cart/state", "table": 1, "network": 2, "recorder": 3}))
        writer.metadata("tendon.recording", {"paths": "**"})
        run = self.open(writer.finish())

        self.assertEqual(run.events(), ["robot/cart/Control.Passed", "robot/cart/Control.Stopped"])
        self.assertEqual(run["robot/cart/Control.Passed"].tolist(), [1.5])
        self.assertEqual(run["robot/cart/Control.Stopped"].tolist(), [None])
        self.assertEqual(run.times("robot/cart/Control.Stopped").tolist(), [5])
        self.assertEqual([tuple(one) for one in run.log],
                         [(7, "warning", "robot/cart", "earlier"),
                          (9, "warning", "robot/cart", "later")])
        self.assertEqual([tuple(one) for one in run.losses()], [(8, "robot/cart/state", 1, 2, 3)])
        self.assertEqual(run.about, {"paths": "**"})
        self.assertEqual(run.tables(), [])

    def test_commands_are_read(self):
        call = parse("struct tendon.Call {\n  took: duration\n  outcome: enum tendon.CallOutcome {\n"
                     "    executed = 0\n    refused = 2\n  }\n  argument: float64\n"
                     "  client: string\n}")
        writer = Writer()
        passed = writer.channel("robot/cart/Control.Passed", "float64", "event")
        move = writer.channel("robot/cart/Control.Move", call.text(), "command")
        writer.message(passed, 0, 5, number(1))
        for sequence, outcome in enumerate(("executed", "refused")):
            writer.message(move, sequence, 6 + sequence, call.encode(
                {"took": 0.5, "outcome": outcome, "argument": 1.5, "client": "desk/pilot/Cart"}))
        run = self.open(writer.finish())

        self.assertEqual(run.commands(), ["robot/cart/Control.Move"])
        self.assertEqual(run.events(), ["robot/cart/Control.Passed"])
        self.assertEqual(run["robot/cart/Control.Move.argument"].tolist(), [1.5, 1.5])
        self.assertEqual(run["robot/cart/Control.Move.client"].tolist(), ["desk/pilot/Cart"] * 2)
        self.assertEqual(run["robot/cart/Control.Move.outcome"].tolist(), [0, 2])
        self.assertEqual(run.enumerators("robot/cart/Control.Move.outcome"),
                         {0: "executed", 2: "refused"})

    def test_topics_of_others_are_listed_and_not_read(self):
        writer = counting(3)
        writer.message(writer.foreign_channel("/camera"), 0, 0, b"?")

        run = self.open(writer.finish())

        self.assertIn("/camera", run.topics())
        self.assertNotIn("/camera", run.paths())
        with self.assertRaises(tendon.NotFound):
            run["/camera"]


POSE = """Point position
Point[2] corners
builtin_interfaces/Time stamp
string name "unknown"
int32 LIMIT=5
uint8[<=4] data
================================================================================
MSG: geometry_msgs/Point
float64 x
float32 y
"""
POSE_SCHEMA = """struct geometry_msgs.Pose {
  position: struct geometry_msgs.Point {
    x: float64
    y: float32
  }
  corners: struct geometry_msgs.Point {
    x: float64
    y: float32
  }[2]
  stamp: duration
  name: string
  data: uint8[]
}"""


class OtherPrograms(OnFile):
    def poses(self):
        writer = Writer()
        schema = writer.schema("geometry_msgs/msg/Pose", POSE)
        channel = writer.foreign_channel("/arm.left/pose", schema=schema)
        for row in range(3):
            point = {"x": float(row), "y": 0.5}
            writer.message(channel, row, row, parse(POSE_SCHEMA).encode(
                {"position": point, "corners": [point, point], "stamp": row + 0.25, "name": "a",
                 "data": [1, 2]}))
        return self.open(writer.finish())

    def test_the_definition_of_a_message_is_its_type(self):
        self.assertEqual(parse_message("geometry_msgs/msg/Pose", POSE).text(), POSE_SCHEMA)

    def test_topics_are_read_by_their_message_definitions(self):
        run = self.poses()

        self.assertEqual(run.other_topics(), ["/arm.left/pose"])
        self.assertEqual(run.events(), [])
        self.assertEqual(run.tables(), [])
        self.assertEqual(run["/arm.left/pose.position.x"].tolist(), [0.0, 1.0, 2.0])
        self.assertEqual(run["/arm.left/pose.corners[1].y"].tolist(), [0.5, 0.5, 0.5])
        self.assertEqual(run["/arm.left/pose.stamp"].astype(np.int64).tolist(),
                         [250_000_000, 1_250_000_000, 2_250_000_000])
        self.assertEqual(run.times("/arm.left/pose").tolist(), [0, 1, 2])
        self.assertIn("/arm.left/pose.position.x", run.paths())

    def test_other_encodings_are_left_out_with_the_reason(self):
        writer = Writer()
        text = writer.foreign_channel("/json", schema=writer.schema("x", "{}", "jsonschema"),
                                      encoding="json")
        bad = writer.foreign_channel("/bad", schema=writer.schema("a/msg/B", "wstring x"))
        for row in range(3):
            writer.message(text, row, row, b"{}")
        writer.message(bad, 0, 0, b"")

        run = self.open(writer.finish())

        self.assertEqual(set(run.left_out), {"/json", "/bad"})
        self.assertEqual(run.left_out["/json"],
                         "3 messages are left out: their encoding is 'json' with a schema in "
                         "'jsonschema', and only 'cdr' with a schema in 'ros2msg' is read")
        self.assertIn("wstring is not read", run.left_out["/bad"])
        with self.assertRaisesRegex(tendon.NotFound, "/json of .* cannot be read: 3 messages"):
            run["/json.x"]

    def test_a_definition_that_cannot_be_read_right_is_refused(self):
        for text, reason in (("Pose x", "the definition of 'Pose' is missing"),
                             ("float64", "'float64' is no field"),
                             ("float64[x] y", "'float64\\[x\\]' is no type"),
                             ("B inner", "the message contains itself"),
                             ("float64 y\nfloat64 y", "a second field of this name"),
                             ("x" * (1 << 21), "at most")):
            with self.subTest(text=text[:20]), self.assertRaisesRegex(tendon.Invalid, reason):
                parse_message("a/msg/B", text)
        chain = "M0 a\nM0 b\n" + "".join(
            f"===\nMSG: a/M{i}\nM{i + 1} a\nM{i + 1} b\n" for i in range(60))
        with self.assertRaisesRegex(tendon.Invalid, "more than 1 MiB"):
            parse_message("a/msg/B", chain + "===\nMSG: a/M60\nbool x\n")


class Compression(OnFile):
    COMPRESSIONS = {"zstd": zstandard.ZstdCompressor().compress, "lz4": lz4.frame.compress}

    def test_zstd_and_lz4_are_read(self):
        for name, compress in self.COMPRESSIONS.items():
            with self.subTest(name=name):
                run = self.open(counting(500, 100, lambda data, how=(name, compress): (
                    how[0], how[1](data))).finish())
                self.assertEqual(run["robot/cart/state.Count"].tolist(), list(range(500)))

    def test_a_missing_module_is_named(self):
        for name, module in (("zstd", "zstandard"), ("lz4", "lz4.frame")):
            compress = self.COMPRESSIONS[name]
            run = self.open(counting(5, 0, lambda data, how=(name, compress): (
                how[0], how[1](data))).finish())
            with self.subTest(name=name), mock.patch.dict(sys.modules, {module: None}), \
                    self.assertRaisesRegex(tendon.Failed, "install python3-"):
                run["robot/cart/state.Count"]

    def test_a_chunk_that_claims_too_much_is_lost(self):
        huge = zstandard.ZstdCompressor().compress(bytes(1 << 20))
        run = self.open(counting(5, 0, lambda data: ("zstd", huge)).finish())
        with self.assertWarnsRegex(tendon.DamagedRecording, "states 1048576 bytes, but the chunk states"):
            self.assertEqual(len(run["robot/cart/state.Count"]), 0)


class Damage(OnFile):
    def test_a_damaged_chunk_is_left_out_and_told(self):
        writer = counting(300, 100)
        content = bytearray(writer.finish())
        content[writer.chunk_starts[1] + 200] ^= 1
        run = self.open(bytes(content))

        with self.assertWarnsRegex(tendon.DamagedRecording,
                                   f"the chunk at {writer.chunk_starts[1]} is lost: the checksum"):
            counts = run["robot/cart/state.Count"]

        self.assertEqual(counts.tolist(), [*range(100), *range(200, 300)])
        self.assertEqual(run.gaps("robot/cart/state").tolist(), [(100, 99_000, 200_000, 100)])
        self.assertEqual(len(run.problems), 1, "each chunk is told of once")

    def test_without_an_index_the_whole_file_is_read(self):
        writer = counting(300, 100)
        content = writer.finish()[:writer.chunk_starts[2] + 500]

        run = self.open(content, problems=2)

        self.assertRegex(run.problems[0], "cut off, or is still being written")
        self.assertEqual(run["robot/cart/state.Count"].tolist(), list(range(200)))

    def test_a_scan_continues_behind_damaged_lengths(self):
        writer = counting(300, 100)
        content = bytearray(writer.finish()[:-20])
        content[writer.chunk_starts[1] + 4] = 0xff  # a byte of the chunk's length
        run = self.open(bytes(content), problems=2)

        self.assertRegex(run.problems[1], "damaged and skipped; the next chunk begins after")
        self.assertEqual(run["robot/cart/state.Count"].tolist(),
                         [*range(100), *range(200, 300)])

    def test_a_row_with_a_missing_part_is_left_out_whole(self):
        writer = Writer()
        count = writer.channel("robot/cart/state.Count", "uint64")
        double = writer.channel("robot/cart/state.Double", "uint64")
        for row in range(5):
            writer.message(count, row, row, number(row))
            if row != 2:
                writer.message(double, row, row, number(2 * row))
        run = self.open(writer.finish())

        with self.assertWarnsRegex(tendon.DamagedRecording, "1 rows of robot/cart/state are left"):
            counts = run["robot/cart/state.Count"]

        self.assertEqual(counts.tolist(), [0, 1, 3, 4])
        self.assertEqual(run["robot/cart/state.Double"].tolist(), [0, 2, 6, 8])
        self.assertEqual(run.times("robot/cart/state").tolist(), [0, 1, 3, 4])

    def test_a_wrong_message_index_is_not_believed(self):
        writer = counting(100)
        content = bytearray(writer.finish())
        place = content.rindex(struct.pack("<QQ", 99_000, 0)[:8], 0, content.rindex(b"\x0f\4"))
        content[place] ^= 1

        run = self.open(bytes(content))

        self.assertEqual(run["robot/cart/state.Count"].tolist(), list(range(100)))

    def test_every_truncation_is_opened_or_refused(self):
        content = counting(4, 2).finish()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            for size in range(len(content)):
                self.path.write_bytes(content[:size])
                try:
                    with tendon.open(self.path) as run:
                        rows = [run[path].tolist() for path in run.paths()]
                except tendon.Invalid:
                    self.assertLess(size, 8)
                    continue
                for values, step in zip(rows, (1, 2)):
                    self.assertEqual(values, list(range(0, step * len(values), step)))

    def test_every_flipped_byte_is_told_or_harmless(self):
        content = counting(4, 2).finish()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            for place in range(8, len(content), 2):
                changed = bytearray(content)
                changed[place] ^= 0x55
                self.path.write_bytes(changed)
                with self.subTest(place=place), tendon.open(self.path) as run:
                    for path in run.paths():
                        step = 2 if path.endswith("Double") else 1
                        self.assertLessEqual(set(run[path].tolist()), set(range(0, 4 * step, step)))

    def test_what_is_no_recording_is_refused(self):
        self.path.write_bytes(b"PK\3\4 and more than eight bytes")
        with self.assertRaisesRegex(tendon.Invalid, "is not a recording: .*PK"):
            tendon.open(self.path)
        with self.assertRaisesRegex(tendon.NotFound, "there is no file"):
            tendon.open(self.path.with_name("nothing"))

    def test_a_closed_recording_says_so(self):
        run = self.open(counting(3).finish())
        run.close()
        with self.assertRaisesRegex(tendon.Failed, "is closed"):
            run["robot/cart/state.Count"]


class Package(unittest.TestCase):
    def test_recordings_need_no_ice(self):
        subprocess.run([sys.executable, "-B", "-c", "import sys; sys.modules['Ice'] = None; "
                        "import tendon; tendon.open"], check=True)


if __name__ == "__main__":
    unittest.main()
