#!/usr/bin/env python3
"""check_report.py skipped|times FOLDER: prints a report from the logs of a preset's last check.

skipped: prints each skipped test with its reason. times: prints the slowest build steps and tests. FOLDER is
build/PRESET. The logs are .ninja_log, which ninja writes, and tests.xml, which tools/check writes in JUnit's format.
"""

import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

SLOWEST = 20
OBJECT = re.compile(r"(?:.*/)?CMakeFiles/([^/]+)\.dir/(.+)")


def reason(output):
    """The reason of a skipped test: the text of GTEST_SKIP(), or the line that begins with
    "skipped"."""
    if told := re.findall(r"^\S+:\d+: Skipped\n(.+(?:\n.+)*?)\n(?:\n|\[)", output, re.MULTILINE):
        return "; ".join(dict.fromkeys(" ".join(text.split()) for text in told))
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    told = next((line for line in lines if line.lower().startswith("skipped")), lines[-1] if lines else "")
    return re.sub(r"^skipped:? *", "", told, flags=re.IGNORECASE) or "the test gave no reason"


def skipped(folder):
    for test in ElementTree.parse(folder / "tests.xml").iter("testcase"):
        if test.get("status") in ("notrun", "disabled"):
            yield f"Skipped {test.get('name')}: {reason(test.findtext('system-out') or '')}"


def build_steps(folder):
    """Yields the seconds and the name of each build step, as of its last run. A step that makes several
    files appears once."""
    steps = {}
    for line in (folder / ".ninja_log").read_text().splitlines():
        fields = line.split("\t")
        if len(fields) == 5:
            begin, end, _, output, command = fields
            steps[output] = (int(begin), int(end), command)
    once = {step: output for output, step in steps.items()}
    for (begin, end, _), output in once.items():
        match = OBJECT.fullmatch(output)
        yield (end - begin) / 1000, f"{match[1]}: {match[2]}" if match else output


def tests(folder):
    for test in ElementTree.parse(folder / "tests.xml").iter("testcase"):
        yield float(test.get("time")), test.get("name")


def times(folder):
    for title, log, read in (("build steps", ".ninja_log", build_steps), ("tests", "tests.xml", tests)):
        if not (folder / log).exists():
            yield f"{folder} has no {log}, so the times of its {title} are unknown; run tools/check."
            continue
        found = sorted(read(folder), reverse=True)
        yield f"{folder}: the slowest of {len(found)} {title}, which took {sum(seconds for seconds, _ in found):.0f} s"
        yield from (f"{seconds:8.1f} s  {name}" for seconds, name in found[:SLOWEST])


def main():
    mode, folder = sys.argv[1], Path(sys.argv[2])
    for line in {"skipped": skipped, "times": times}[mode](folder):
        print(line)


if __name__ == "__main__":
    main()
