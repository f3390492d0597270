#!/usr/bin/env python3
"""api_test.py DOXYFILE: doxygen describes the public headers without a warning, and every class has a description."""
import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
STRICT = """
OUTPUT_DIRECTORY = "{folder}"
GENERATE_HTML = NO
GENERATE_XML = YES
EXTRACT_ALL = NO
WARN_IF_UNDOCUMENTED = YES
WARN_AS_ERROR = NO
"""


def doxygen(settings):
    """Runs doxygen. Returns its output and its exit code."""
    done = subprocess.run(["doxygen", "-"], input=settings, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, check=False)
    return done.stdout, done.returncode


def main(doxyfile):
    if shutil.which("doxygen") is None:
        print("skipped: doxygen is not installed; tools/setup installs it")
        return SKIPPED
    with open(doxyfile, encoding="utf-8") as file:
        settings = file.read()
    complaints, failed = doxygen(settings)
    with tempfile.TemporaryDirectory() as folder:
        strict, _ = doxygen(settings + STRICT.format(folder=folder))
    # Specialisations of templates need no description: [^<] leaves them out.
    bare = re.findall(r"^.*Compound [^<\n]* is not documented\.$", strict, re.M)
    print("\n".join([complaints, *bare]).strip() or "no complaint")
    return 1 if failed or complaints or bare else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
