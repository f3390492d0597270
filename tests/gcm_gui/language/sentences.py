#!/usr/bin/env python3
"""sentences.py SOURCES LUPDATE: checks that every sentence of the window is translated.

Sentences must be in Words::tr(), and each must have a translation in every language/*.ts. The translation must have the
same placeholders (%1), the same spaces at its ends, and a mnemonic if the sentence has one. Prints what is wrong; the
exit code is then 1.
"""

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from xml.etree import ElementTree

SHOWN = ("setText", "setToolTip", "setAccessibleName", "setPlaceholderText", "setWindowTitle", "setTitle",
         "addAction", "addMenu", "addPage", "setEmptyText", "setLabelText", "setStatusTip")
BARE = re.compile(r"\b(%s)\(\s*(?:QStringLiteral\(|QString\()?\"([^\"]*)\"" % "|".join(SHOWN))


def bare_sentences(sources):
    """Yields the texts that are shown without Words::tr(), so that they cannot be translated."""
    for path in sorted(sources.rglob("*.cpp")):
        text = path.read_text(encoding="utf-8")
        for match in BARE.finditer(text):
            words = re.sub(r"%\d|\\.", "", match[2])
            is_command = words.startswith(("gcm ", "lcm "))
            if re.search(r"[A-Za-z]{3}", words) and not words.isupper() and not is_command:
                line = text.count("\n", 0, match.start()) + 1
                yield f'{path.relative_to(sources)}:{line}: "{match[2]}" is shown, but not by Words::tr()'


def faults(source, translation):
    for what, pattern in (("places", r"%L?\d|%n"), ("blanks at the ends", r"^\s+|\s+$"), ("mnemonics", r"&(?=\w)")):
        if sorted(re.findall(pattern, source)) != sorted(re.findall(pattern, translation)):
            yield f"other {what} than the English"


def wrong_translations(path):
    for message in ElementTree.parse(path).iter("message"):
        source, translation = message.find("source").text, message.find("translation")
        if translation.get("type") == "unfinished" or not translation.text:
            yield f'{path.name}: "{source}" is not translated; add it to gcm_gui/language/{path.name}'
            continue
        for fault in faults(source, translation.text):
            yield f'{path.name}: "{source}" -> "{translation.text}" has {fault}'


def main(sources, lupdate):
    wrong = list(bare_sentences(sources))
    with tempfile.TemporaryDirectory() as folder:
        files = [Path(shutil.copy(path, folder)) for path in sorted((sources / "language").glob("*.ts"))]
        subprocess.run([lupdate, "-silent", "-locations", "none", "-no-obsolete", "-I", sources.parent, sources,
                        "-ts", *files], check=True)
        for path in files:
            wrong += wrong_translations(path)
    print("\n".join(wrong) or f"{len(files)} languages, nothing is missing")
    return 1 if wrong or not files else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), sys.argv[2]))
