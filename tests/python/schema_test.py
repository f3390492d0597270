"""Tests the codec: converting values to bytes and back, and rejecting wrong values and bytes."""
import math
import struct
import unittest
from random import Random

from tendon import Invalid
from tendon.payload.schema import Duration, Enum, Field, List, Number, String, Structure
from tendon.payload.schema_text import MAX_DEPTH, MAX_TEXT, parse, parse_all

MODE = Enum("arm.Mode", {"off": 0, "fault": -1})
GOAL = Structure("arm.Goal", (
    Field("joint", Number("uint8")), Field("position", List(Number("float64"), 2), "rad"),
    Field("mode", MODE), Field("name", String()), Field("path", List(Number("int16")))))
GOAL_TEXT = """struct arm.Goal {
  joint: uint8
  position: float64[2] in rad
  mode: enum arm.Mode {
    off = 0
    fault = -1
  }
  name: string
  path: int16[]
}"""
VALUE = {"joint": 7, "position": [1.0, -2.5], "mode": "fault", "name": "é", "path": [1, -1]}
BODY = (b"\x07" + bytes(7) + struct.pack("<dd", 1.0, -2.5) + b"\xff\xff\xff\xff"
        + b"\x03\0\0\0\xc3\xa9\0" + bytes(1) + b"\x02\0\0\0\x01\0\xff\xff")


class Codec(unittest.TestCase):
    def assert_refused(self, schema, value, sentence):
        with self.assertRaises(Invalid) as caught:
            schema.encode(value)
        self.assertEqual(str(caught.exception), sentence)

    def test_a_structure_is_encoded_as_cdr(self):
        self.assertEqual(GOAL.encode(VALUE), BODY)
        self.assertEqual(GOAL.decode(BODY), VALUE)

    def test_every_number_keeps_its_limits(self):
        for kind, values in {
                "bool": [False, True], "int8": [-128, 127], "uint8": [0, 255],
                "int16": [-32768, 32767], "uint16": [65535], "int32": [-2**31, 2**31 - 1],
                "uint32": [2**32 - 1], "int64": [-2**63, 2**63 - 1], "uint64": [2**64 - 1],
                "float32": [1.5, math.inf], "float64": [0.1, -math.inf]}.items():
            schema = Number(kind)
            for value in values:
                with self.subTest(kind=kind, value=value):
                    body = schema.encode(value)
                    self.assertEqual(len(body), schema.minimum_size)
                    self.assertEqual(schema.decode(body), value)
        self.assertTrue(math.isnan(Number("float64").decode(Number("float64").encode(math.nan))))

    def test_integers_beyond_doubles_are_exact(self):
        for kind, value in (("int64", 2**53 + 1), ("uint64", 2**53 + 1), ("int64", -2**53 - 1),
                            ("uint64", 2**64 - 2)):
            with self.subTest(kind=kind, value=value):
                read = Number(kind).decode(Number(kind).encode(value))
                self.assertIs(type(read), int)
                self.assertEqual(read, value)

    def test_every_double_keeps_its_bits(self):
        random = Random(20)
        edges = (-0.0, 5e-324, -5e-324, 1.7976931348623157e308, 0.1 + 0.2, math.inf, -math.inf)
        for _ in range(1000):
            bits = struct.pack("<Q", random.getrandbits(64))
            value = struct.unpack("<d", bits)[0]
            if not math.isnan(value):
                self.assertEqual(Number("float64").encode(value), bits)
        for value in edges:
            body = Number("float64").encode(value)
            self.assertEqual(struct.pack("<d", Number("float64").decode(body)), body)

    def test_durations_are_seconds(self):
        self.assertEqual(Duration().encode(-1.5), b"\xfe\xff\xff\xff\x00\x65\xcd\x1d")
        self.assertEqual(Duration().decode(b"\xfe\xff\xff\xff\x00\x65\xcd\x1d"), -1.5)
        self.assertEqual(Duration().encode(0.1), struct.pack("<iI", 0, 100_000_000))

    def test_an_empty_structure_is_one_byte(self):
        nothing = Structure("tendon.None", ())
        self.assertEqual(nothing.encode(None), b"\0")
        self.assertIsNone(nothing.decode(b"\0"))

    def test_uint8_sequences_are_bytes(self):
        self.assertEqual(List(Number("uint8")).encode(b"abc"), b"\x03\0\0\0abc")
        self.assertEqual(List(Number("uint8")).decode(b"\x03\0\0\0abc"), b"abc")
        self.assertEqual(List(Number("uint8")).encode([1, 2]), b"\x02\0\0\0\x01\x02")

    def test_an_empty_sequence_adds_no_alignment(self):
        schema = Structure("t.T", (Field("a", List(Number("float64"))), Field("b", Number("int8"))))
        self.assertEqual(schema.encode({"a": [], "b": 5}), b"\0\0\0\0\x05")
        self.assertEqual(schema.decode(b"\0\0\0\0\x05"), {"a": [], "b": 5})

    def test_only_padding_to_eight_may_follow(self):
        self.assertEqual(Number("int8").decode(b"\x05" + bytes(7)), 5)
        with self.assertRaisesRegex(Invalid, "^these 9 bytes are not a valid int8: there is more "
                                             "data after the end of the value$"):
            Number("int8").decode(b"\x05" + bytes(8))

    def test_an_unnamed_enum_value_is_a_number(self):
        self.assertEqual(MODE.decode(b"\x09\0\0\0"), 9)

    def test_truncated_bodies_are_rejected(self):
        for size in range(len(BODY)):
            with self.subTest(size=size), self.assertRaises(Invalid):
                GOAL.decode(BODY[:size])

    def test_impossible_lengths_are_rejected(self):
        for element in (Number("float64"), String(), GOAL, List(Number("uint8"), 1 << 20)):
            for length in (2, 0x7fffffff, 0xffffffff):
                with self.subTest(element=element.type_name), self.assertRaises(Invalid):
                    List(element).decode(struct.pack("<I", length))
        with self.assertRaisesRegex(Invalid, "a sequence of 3, for which too few bytes follow"):
            List(String()).decode(b"\x03\0\0\0\x01\0\0\0\0")
        with self.assertRaises(Invalid):
            List(Number("float64"), 1 << 27).decode(bytes(16))

    def test_malformed_values_are_rejected(self):
        for schema, body in [
                (Number("bool"), b"\x02"), (List(Number("bool")), b"\x02\0\0\0\x01\x02"),
                (String(), b"\0\0\0\0"), (String(), b"\x02\0\0\0ab"),
                (Duration(), struct.pack("<iI", 0, 1_000_000_000))]:
            with self.subTest(schema=schema.type_name, body=body), self.assertRaises(Invalid):
                schema.decode(body)

    def test_mutated_bodies_are_values_or_invalid(self):
        random = Random(7)
        for _ in range(3000):
            body = bytearray(BODY)
            for _ in range(random.randint(1, 4)):
                body[random.randrange(len(body))] = random.choice((0, 1, 0x7f, 0xff, 9))
            del body[random.choice((len(body), random.randrange(len(body)))):]
            try:
                value = GOAL.decode(bytes(body))
            except Invalid:
                continue
            self.assertEqual(list(value), list(VALUE))

    def test_errors_name_place_expectation_and_finding(self):
        self.assert_refused(GOAL, {**VALUE, "position": [1.0, "x"]},
                            "position[1]: expected a number (rad), got string 'x'")
        self.assert_refused(GOAL, {**VALUE, "position": [1.0]},
                            "position: expected a list of 2 float64 (rad), got a list of 1")
        self.assert_refused(GOAL, {**VALUE, "joint": 256},
                            "joint: expected an integer from 0 to 255, got number 256")
        self.assert_refused(GOAL, {**VALUE, "joint": True},
                            "joint: expected an integer from 0 to 255, got True")
        self.assert_refused(GOAL, {**VALUE, "mode": "fautl"},
                            "mode: expected one of 'off', 'fault', got string 'fautl'; "
                            "did you mean 'fault'?")
        self.assert_refused(GOAL, {**VALUE, "nam": ""},
                            "unknown key 'nam'; did you mean 'name'?")
        self.assert_refused(GOAL, {}, "missing key 'joint' (uint8)")
        self.assert_refused(GOAL, 5, "expected a dict (arm.Goal), got number 5")
        self.assert_refused(String(), "a\0b", "expected a string without '\\0', "
                            "got string 'a\\x00b'")
        self.assert_refused(Number("float32"), 1e39,
                            "expected a number that float32 can hold, got number 1e+39")
        self.assert_refused(Number("float64"), 10**400, "expected a number that float64 can hold, "
                            "got number " + f"{10**400!r:.40}")
        self.assert_refused(Duration(), math.nan,
                            "expected a number of seconds, below 68 years, got number nan")


class Text(unittest.TestCase):
    def assert_refused(self, text, sentence):
        with self.assertRaises(Invalid) as caught:
            parse(text)
        self.assertEqual(str(caught.exception), sentence)

    def test_a_printed_schema_parses_back(self):
        for text in (GOAL_TEXT, "float64", "int8[3][]", "string[]", "struct tendon.None {\n}",
                     "struct a.B {\n  c: struct d.E {\n    f: duration[2] in s\n  }[]\n}"):
            with self.subTest(text=text):
                self.assertEqual(parse(text).text(), text)
        self.assertEqual(parse(GOAL_TEXT), GOAL)

    def test_help_and_ranges_are_ignored(self):
        with_help = GOAL_TEXT.replace("  joint", "  # Which one: 0 }\n  @ 0 to 6\n  joint")
        self.assertEqual(parse(with_help), GOAL)

    def test_errors_name_line_and_column(self):
        self.assert_refused("struct a.B {\n  c: float65\n}",
                            "schema line 2 column 6: expected a type")
        self.assert_refused("float64[0]",
                            "schema line 1 column 11: an array has at least one element")
        self.assert_refused("struct a.B {\n  c: int8\n  c: int8\n}",
                            "schema line 3 column 4: a second field of this name")
        self.assert_refused("int8 int8", "schema line 1 column 6: expected the end")
        self.assert_refused("enum a.B {\n}",
                            "schema line 2 column 2: an enum has at least one enumerator")

    def test_truncated_texts_are_rejected(self):
        for size in range(len(GOAL_TEXT)):
            with self.subTest(size=size), self.assertRaises(Invalid):
                parse(GOAL_TEXT[:size])

    def test_oversized_schemas_are_rejected(self):
        for text, why in {
                "int8" + "[]" * MAX_DEPTH: "more than 64 levels",
                "struct a { a: " * (MAX_DEPTH + 1): "more than 64 levels",
                "float64[4294967295]": "over 2 GiB", "float64[99999999999]": "of 32 bits",
                "int8[65536][65536]": "over 2 GiB", " " * (MAX_TEXT + 1): "at most 1048576",
                "struct a { b: int8[2000000000] c: int8[2000000000] }": "over 2 GiB"}.items():
            with self.subTest(text=text[:40]), self.assertRaisesRegex(Invalid, why):
                parse(text)

    def test_several_schemas_are_found_by_name(self):
        found = parse_all(GOAL_TEXT + "\nstruct tendon.None {\n}\n")
        self.assertEqual(found, {"arm.Goal": GOAL, "tendon.None": Structure("tendon.None", ())})


if __name__ == "__main__":
    unittest.main()
