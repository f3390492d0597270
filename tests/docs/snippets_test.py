#!/usr/bin/env python3
"""snippets_test.py ROOT: checks the code blocks of the README, of docs/ and of the pages beside the code.

Every C++, JSON and Python block must occur, line for line, in a file that the build or a test reads. The lines of every
CMake block must occur, in the same order, in one of the projects of tests/install, which are outside of the tree.
"""
import pathlib
import re
import sys


FOLDERS = ("docs/tutorials", "components", "resources/systems", "tests/core/payload/robot")


def lines_of(text):
    return [line.strip() for line in text.splitlines() if line.strip()]


def stands_in(block, source):
    return any(source[i:i + len(block)] == block for i in range(len(source) - len(block) + 1))


def stands_in_order(block, source):
    rest = iter(source)
    return all(line in rest for line in block)


def main(root):
    sources = [lines_of(path.read_text(encoding="utf-8"))
               for folder in FOLDERS for path in (root / folder).rglob("*")
               if path.suffix in {".h", ".cpp", ".json", ".py"}]
    projects = [lines_of(path.read_text(encoding="utf-8").replace("${COMPONENTS}", "core"))
                for path in (root / "tests/install").glob("*/CMakeLists.txt")]
    missing = blocks = 0
    pages = [page for folder in ("docs", "components", "core") for page in sorted((root / folder).rglob("*.md"))]
    for page in [root / "README.md", *pages]:
        for language, text in re.findall(r"^```(cpp|json|cmake|python)\n(.*?)^```", page.read_text(encoding="utf-8"),
                                         re.M | re.S):
            blocks += 1
            block = lines_of(text)
            if language == "cmake":
                found = any(stands_in_order(block, project) for project in projects)
            else:
                found = any(stands_in(block, source) for source in sources)
            if not found:
                missing += 1
                print(f"{page.relative_to(root)}: this {language} block is in no file that is built:\n{text}")
    print(f"{blocks} blocks, {missing} of them stray")
    return 1 if missing or not blocks else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
