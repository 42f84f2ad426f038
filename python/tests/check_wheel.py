"""Builds the wheel with pip, installs it in a virtual environment of its own, and uses it in a clean directory.

check_wheel.py SOURCE BUILD SCRATCH. Nothing is downloaded: numpy is the one that the interpreter has.
"""
import os
import shutil
import subprocess
import sys
import venv
from pathlib import Path

USE = """
import pathlib, sys
import waymark as wm
assert "site-packages" in wm.__file__, wm.__file__
answer = wm.run("walk past the lamp to the easel", map="grid", start=(1, 9, 0))
assert answer.formula.holds(answer.route.word)
pathlib.Path("route.svg").write_text(answer._repr_svg_())
assert pathlib.Path("route.svg").read_text().count("<svg") == 2  # the automaton stands beside the map
print(answer.understood, answer.route)
"""


def main(source, build, scratch):
    scratch = Path(scratch)
    shutil.rmtree(scratch, ignore_errors=True)
    clean = scratch / "clean"
    clean.mkdir(parents=True)
    environment = {**os.environ, "WAYMARK_BUILD_DIR": build, "PIP_NO_INDEX": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    for name in ("WAYMARK_DATA", "PYTHONPATH"):
        environment.pop(name, None)
    subprocess.run([sys.executable, "-m", "pip", "wheel", "--no-build-isolation", "--no-deps", "-w", str(scratch), source],
                   env=environment, check=True)
    [wheel] = scratch.glob("waymark-*.whl")
    venv.create(scratch / "venv", system_site_packages=True, with_pip=True)
    python = scratch / "venv" / "bin" / "python"
    subprocess.run([str(python), "-m", "pip", "install", "--no-deps", str(wheel)], env=environment, check=True)
    subprocess.run([str(python), "-c", USE], cwd=clean, env=environment, check=True)
    for suite in ("formulas", "routes", "stubs"):
        subprocess.run([str(python), "-B", str(Path(source) / "python/tests" / f"test_{suite}.py")],
                       cwd=clean, env=environment, check=True)
    print(f"{wheel.name}: {wheel.stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main(*sys.argv[1:])
