#!/usr/bin/env python3
"""check_report.py tests|times FOLDER: prints a report from the logs of a preset's last check.

tests: prints each skipped test with its reason, and the number of tests. times: prints the slowest build steps and
tests. FOLDER is build/PRESET. The logs are .ninja_log, which ninja writes, tests.xml, which tools/check writes in
JUnit's format, and tests/results/RUN.xml, which GoogleTest writes for a run of several tests.
"""

import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

SLOWEST = 20
NO_REASON = "the test gave no reason"
OBJECT = re.compile(r"(?:.*/)?CMakeFiles/([^/]+)\.dir/(.+)")


def reason(output):
    """The reason of a skipped test: the text of GTEST_SKIP(), or the line that begins with
    "skipped"."""
    if told := re.findall(r"^\S+:\d+: Skipped\n(.+(?:\n.+)*?)\n(?:\n|\[)", output, re.MULTILINE):
        return "; ".join(dict.fromkeys(" ".join(text.split()) for text in told))
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    told = next((line for line in lines if line.lower().startswith("skipped")), lines[-1] if lines else "")
    return re.sub(r"^skipped:? *", "", told, flags=re.IGNORECASE) or NO_REASON


def tests(folder):
    """Yields the seconds, the name and, if it was skipped, the reason of each test: first of those of a run of
    GoogleTest, where there is one."""
    for run in ElementTree.parse(folder / "tests.xml").iter("testcase"):
        results = folder / "tests" / "results" / f"{run.get('name')}.xml"
        if not results.exists():
            told = run.findtext("system-out") or ""
            skipped = reason(told) if run.get("status") in ("notrun", "disabled") else None
            yield float(run.get("time")), run.get("name"), skipped
            continue
        for test in ElementTree.parse(results).iter("testcase"):
            if test.get("status") != "run":
                continue
            skips = [" ".join(skip.get("message").split("\n")[1:]) for skip in test.iter("skipped")]
            skipped = ("; ".join(dict.fromkeys(map(str.strip, skips))) or NO_REASON) if skips else None
            yield float(test.get("time")), f"{test.get('classname')}.{test.get('name')}", skipped


def report(folder):
    found = list(tests(folder))
    yield from (f"Skipped {name}: {skipped}" for _, name, skipped in found if skipped is not None)
    skips = sum(skipped is not None for _, _, skipped in found)
    yield f"Tests: {len(found) - skips} ran, {skips} were skipped."


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


def times(folder):
    for title, log, read in (("build steps", ".ninja_log", build_steps), ("tests", "tests.xml", tests)):
        if not (folder / log).exists():
            yield f"{folder} has no {log}, so the times of its {title} are unknown; run tools/check."
            continue
        found = sorted(((seconds, name) for seconds, name, *_ in read(folder)), reverse=True)
        yield f"{folder}: the slowest of {len(found)} {title}, which took {sum(seconds for seconds, _ in found):.0f} s"
        yield from (f"{seconds:8.1f} s  {name}" for seconds, name in found[:SLOWEST])


def main():
    mode, folder = sys.argv[1], Path(sys.argv[2])
    for line in {"tests": report, "times": times}[mode](folder):
        print(line)


if __name__ == "__main__":
    main()
