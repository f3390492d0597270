#!/usr/bin/env python3
"""compile_commands.py ROOT BUILD FOLDER FILE...: finds the command that compiles each of these files
separately.

Writes to FOLDER: compile_commands.json, for clang-tidy; sources, the list of files to check; and
line_filter, which excludes findings in other files. FILE is relative to ROOT. The exit code is 3 if
BUILD has no command for a file.
"""

import json
import re
import shlex
import sys
from pathlib import Path

UNKNOWN = 3  # exit code
JOINED = re.compile(r'^#include "(.+)"$', re.MULTILINE)


def commands_of(build):
    """The commands of all sources, by path. A source that CMake compiles together with others has the
    command of the generated source that includes it."""
    commands = {}
    database = build / "compile_commands.json"
    for command in json.loads(database.read_text()) if database.exists() else []:
        file = command["file"]
        commands.setdefault(file, command)
        if "/Unity/" in file and Path(file).exists():
            for source in JOINED.findall(Path(file).read_text()):
                commands.setdefault(source, {**command, "file": source})
    return commands


def alone(command, source):
    """The command, with another source."""
    words = shlex.split(command["command"])
    return {"directory": command["directory"], "file": source, "arguments": words[: words.index("-c") + 1] + [source]}


def source_of(path, commands):
    """The source to compile for a file: the file itself, the .cpp file of a header, or the source that
    CMake generates to check the header."""
    beside = str(path.with_suffix(".cpp"))
    if path.suffix != ".h" or beside in commands:
        return beside
    check = "_verify_interface_header_sets/"
    return next((file for file in commands if check in file
                 and str(path).endswith("/" + file.rpartition(check)[2].removesuffix(".cxx"))), None)


def main():
    root, build, folder, *names = sys.argv[1:]
    paths = [Path(root).resolve() / name for name in names]
    if other := [name for name, path in zip(names, paths) if path.suffix not in (".h", ".cpp")]:
        sys.exit("Only .h and .cpp files are read by clang-tidy, not: " + ", ".join(other))
    commands = commands_of(Path(root, build))
    sources = {path: source_of(path, commands) for path in paths}
    unknown = [name for name, path in zip(names, paths)
               if not commands or (sources[path] not in commands and path.with_suffix(".cpp").exists())]
    if unknown:
        print("Nothing in preset dev compiles these; add them to a CMakeLists.txt: " + ", ".join(unknown),
              file=sys.stderr)
        sys.exit(UNKNOWN)
    if unread := [name for name, path in zip(names, paths) if not sources[path]]:
        print("Not checked, because no source has the name of the header: " + ", ".join(unread))

    wanted = sorted({source for source in sources.values() if source})
    Path(folder, "compile_commands.json").write_text(json.dumps([alone(commands[s], s) for s in wanted]))
    Path(folder, "sources").write_text("".join(source + "\n" for source in wanted))
    Path(folder, "line_filter").write_text(json.dumps([{"name": str(path)} for path in {*paths, *map(Path, wanted)}]))


if __name__ == "__main__":
    main()
