"""Tests the catalogue: applying changes, and looking up names."""
import unittest

from tendon import Failed, Invalid, NotFound, Unreachable
from tendon.catalog import Catalogue
from tendon.errors import Denied
from tendon.middleware.address import gcm_address, parse_address
from tendon.paths import Path, parse_interface, parse_path, select

ROBOT = {"name": "robot", "instance": 1, "state": "alive", "reason": "", "address": "127.0.0.1:5"}
STOP = {"name": "Stop", "signature": {"kind": "void"}}
ARM = {"name": "arm", "provided": [{"name": "Control", "commands": [STOP]}],
       "tables": [{"name": "state", "columns": [
           {"name": "Joints", "type": "arm.JointState", "fingerprint": {"high": 1, "low": 2}}]}]}
LINK = {"id": 4}


def change(revision, kind, process="robot", **more):
    return {"revision": revision, "kind": kind, "process": process, "component": "",
            "connection": 0, "processes": [], "components": [], "connections": [], **more}


def filled():
    catalog = Catalogue(10)
    for step in (change(11, "process", processes=[ROBOT]),
                 change(12, "component", components=[ARM]),
                 change(13, "connection", connections=[LINK])):
        assert catalog.apply(step)
    return catalog


class Changes(unittest.TestCase):
    def test_add_and_remove(self):
        catalog = filled()
        self.assertEqual(catalog.process("robot").components, {"arm": ARM})
        self.assertEqual(catalog.process("robot").connections, {4: LINK})

        self.assertTrue(catalog.apply(change(14, "component_removed", component="arm")))
        self.assertTrue(catalog.apply(change(15, "connection_removed", connection=4)))
        self.assertEqual(catalog.process("robot").components, {})
        self.assertEqual(catalog.process("robot").connections, {})
        self.assertTrue(catalog.apply(change(16, "process_removed")))
        self.assertEqual(catalog.processes, {})

    def test_a_new_instance_starts_empty(self):
        catalog = filled()
        self.assertTrue(catalog.apply(change(14, "process", processes=[{**ROBOT, "instance": 2}])))
        self.assertEqual(catalog.process("robot").components, {})

    def test_inapplicable_changes_are_rejected(self):
        catalog = filled()
        for step in (change(13, "process_removed"), change(15, "process_removed"),
                     change(14, "process_removed", process="desk"),
                     change(14, "process", processes=[]), change(14, "component"),
                     change(14, "component_removed", component="leg"), change(14, 99)):
            with self.subTest(step=step):
                self.assertFalse(catalog.apply(step))
                self.assertEqual(catalog.revision, 13)

    def test_a_copy_is_independent(self):
        catalog = filled()
        copy = catalog.copy()
        self.assertTrue(copy.apply(change(14, "component_removed", component="arm")))
        self.assertIn("arm", catalog.process("robot").components)
        self.assertEqual(catalog.revision, 13)


class Names(unittest.TestCase):
    def assert_none(self, kind, sentence, function, *arguments):
        with self.assertRaises(kind) as caught:
            function(*arguments)
        self.assertEqual(str(caught.exception), sentence)

    def test_commands_and_columns_are_found(self):
        catalog = filled()
        self.assertEqual(catalog.command(parse_path("robot/arm/Control.Stop")), STOP)
        column = catalog.command(parse_path("robot/arm/state.Joints.position[0]"))
        self.assertEqual(column["signature"], {"kind": "read", "out": {"high": 1, "low": 2}})
        self.assertEqual(catalog.table(parse_path("robot/arm"))["name"], "state")

    def test_similar_names_are_suggested(self):
        catalog = filled()
        for path, sentence in {
                "robbot/arm": "no process 'robbot'; did you mean 'robot'?",
                "robot/leg/Control.Stop": "no component 'robot/leg'; there is 'arm'",
                "robot/arm/Contrl.Stop": "no provided interface 'robot/arm/Contrl'; "
                                         "did you mean 'Control'?",
                "robot/arm/Control.Stpo": "no command 'robot/arm/Control.Stpo'; "
                                          "did you mean 'Stop'?"}.items():
            path = parse_path(path if "." in path else path + "/a.b")
            with self.subTest(path=path):
                self.assert_none(NotFound, sentence, catalog.command, path)
        self.assert_none(NotFound, "no state table 'robot/arm/state-Fast'; did you mean 'state'?",
                         catalog.table, parse_path("robot/arm/state-Fast"))
        self.assert_none(Invalid, "'robot/arm' does not name a command: expected "
                         "process/component/interface.member",
                         catalog.command, Path("robot", "arm"))

    def test_an_unavailable_process_is_reported_with_a_reason(self):
        catalog = filled()
        gone = {**ROBOT, "state": "lost", "reason": "killed"}
        self.assertTrue(catalog.apply(change(14, "process", processes=[gone])))
        self.assert_none(Failed, "process 'robot' is lost (killed); start it again first",
                         catalog.present, "robot")
        self.assertTrue(catalog.apply(change(15, "process", processes=[{**ROBOT, "address": ""}])))
        self.assert_none(Unreachable, "process 'robot' does not listen", catalog.present, "robot")

    def test_paths_are_parsed(self):
        self.assertEqual(parse_path("robot/arm/state.Joints.position[0]"),
                         Path("robot", "arm", "state", "Joints", ".position[0]"))
        self.assertEqual(parse_path("robot"), Path("robot"))
        self.assertEqual(parse_interface("a/b/C"),
                         {"process": "a", "component": "b", "interface": "C"})
        for text in ("", "/arm", "a b", "a/b/c.", "a/b/c.d[", "a/b/c.d[x]", "a/b/c.d..e",
                     "a/" + "b" * 65, "a/b/c/d"):
            with self.subTest(text=text), self.assertRaises(Invalid):
                parse_path(text)
        for text in ("a/b", "a/b/c/d", "a//c", ""):
            with self.subTest(text=text), self.assertRaises(Invalid):
                parse_interface(text)

    def test_fields_are_selected(self):
        value = {"position": [1, 2], "name": "x"}
        self.assertEqual(select(value, ""), value)
        self.assertEqual(select(value, ".position[1]"), 2)
        self.assert_none(NotFound, "there is no field 'positon'; did you mean 'position'?",
                         select, value, ".positon")
        self.assert_none(NotFound, "there is no element [2]", select, value, ".position[2]")
        self.assert_none(NotFound, "there is no element [0]", select, value, ".name[0]")

    def test_only_local_addresses_are_accepted(self):
        self.assertEqual(str(parse_address("localhost:5")), "127.0.0.1:5")
        self.assertEqual(str(parse_address("[::1]:5")), "[::1]:5")
        self.assertEqual(gcm_address("127.0.0.1"), "127.0.0.1:10705")
        for text in ("127.0.0.1", "::1:5", ":5", "127.0.0.1:0", "127.0.0.1:65536", "a b:5",
                     '127.0.0.1" -p 6:5'):
            with self.subTest(text=text), self.assertRaises(Invalid):
                parse_address(text)
        for text in ("10.0.0.1:5", "127.0.0.1.example:5", "0.0.0.0:5"):
            with self.subTest(text=text), self.assertRaisesRegex(Denied, "is on another machine"):
                parse_address(text)


if __name__ == "__main__":
    unittest.main()
