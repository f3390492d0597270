#!/usr/bin/env python3
"""Every C++ and JSON block of the README and the tutorials stands, line for line, in a file that the build compiles or
reads."""
import pathlib
import re
import sys


def lines_of(text):
    return [line.strip() for line in text.splitlines() if line.strip()]


def stands_in(block, source):
    return any(source[i:i + len(block)] == block for i in range(len(source) - len(block) + 1))


def main(root):
    sources = {path: lines_of(path.read_text(encoding="utf-8"))
               for path in sorted((root / "docs/tutorials").rglob("*"))
               if path.suffix in {".h", ".cpp", ".json"}}
    pages = [root / "README.md", *sorted((root / "docs").glob("[0-9]*.md"))]
    missing = blocks = 0
    for page in pages:
        for language, text in re.findall(r"^```(cpp|json)\n(.*?)^```", page.read_text(encoding="utf-8"), re.M | re.S):
            blocks += 1
            if not any(stands_in(lines_of(text), source) for source in sources.values()):
                missing += 1
                print(f"{page.name}: this {language} block is in no file of docs/tutorials:\n{text}")
    print(f"{blocks} blocks, {missing} of them stray")
    return 1 if missing or not blocks else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
