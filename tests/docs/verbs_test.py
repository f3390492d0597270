#!/usr/bin/env python3
"""verbs_test.py GCM PAGE: checks that the page explains every verb of `gcm help`, and shows a command with each."""
import pathlib
import re
import subprocess
import sys


def main(gcm, page):
    printed = subprocess.run([gcm, "help"], text=True, stdout=subprocess.PIPE, check=True).stdout
    verbs = re.findall(r"^  ([a-z-]+)  ", printed.split("\noptions\n")[0], re.M)
    text = pathlib.Path(page).read_text(encoding="utf-8")
    commands = "\n".join(re.findall(r"^```sh\n(.*?)^```", text, re.M | re.S))
    missing = [verb for verb in verbs if not re.search(rf"^gcm .*\b{verb}\b", commands, re.M)]
    for verb in missing:
        print(f"{page} has no command with the verb '{verb}' of gcm help")
    return 1 if missing or not verbs else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
