"""installed_test.py CMAKE BUILD: checks that the installed package is complete, and works without this tree."""
import os
import pathlib
import subprocess
import sys
import tempfile

PACKAGE = "share/tendon/python"


def main(cmake, build):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([cmake, "--install", build, "--prefix", folder, "--component", "python"],
                       check=True, stdout=subprocess.DEVNULL)
        installed = pathlib.Path(folder) / PACKAGE
        stray = [path for path in installed.rglob("*")
                 if path.is_symlink() or path.name == "__pycache__"]
        if stray:
            sys.exit(f"this was installed, too: {stray}")
        where = subprocess.run(
            [sys.executable, "-B", "-c", "import tendon; print(tendon.__file__)"], cwd=folder,
            env={**os.environ, "PYTHONPATH": str(installed)}, text=True, stdout=subprocess.PIPE,
            check=True).stdout.strip()
        if where != str(installed / "tendon" / "__init__.py"):
            sys.exit(f"imported was {where}")
    print("the installed package can be imported")


if __name__ == "__main__":
    main(*sys.argv[1:])
