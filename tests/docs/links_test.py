#!/usr/bin/env python3
"""links_test.py ROOT: checks that every link of a page to a file or folder of this tree leads to one, and that
docs/README.md names every page of docs/."""
import pathlib
import re
import sys


def main(root):
    root = pathlib.Path(root)
    docs = root / "docs"
    wrong = []
    folders = ("docs", "components", "core", "gcm_console", "gcm_gui", "resources", "tests")
    pages = [*root.glob("*.md"), *(page for folder in folders for page in (root / folder).rglob("*.md"))]
    for page in pages:
        for target in re.findall(r"\]\(([^)#\s]+)", page.read_text(encoding="utf-8")):
            if "://" not in target and not (page.parent / target).exists():
                wrong.append(f"{page.relative_to(root)} links to {target}, which is not there")
    index = (docs / "README.md").read_text(encoding="utf-8")
    for page in docs.rglob("*.md"):
        name = page.relative_to(docs).as_posix()
        if name != "README.md" and f"]({name})" not in index:
            wrong.append(f"docs/README.md does not name {name}")
    print("\n".join(wrong) or f"{len(pages)} pages, no broken link")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
