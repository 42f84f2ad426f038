"""The build backend of the Python package (PEP 517): CMake builds, `cmake --install` lays out, this packs the wheel.

The build tree is build/python of the checkout, as of the preset `python`; WAYMARK_BUILD_DIR names another one, which is
used as it is configured. CMAKE_BUILD_PARALLEL_LEVEL and CMAKE_ARGS are heeded. Nothing is downloaded.
"""
import base64
import hashlib
import os
import re
import shlex
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TIME = (2024, 1, 1, 0, 0, 0)  # of every file in a wheel: same files, same bytes


def _version():
    return re.search(r"project\(waymark VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


def _tag():
    python = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def _metadata():
    readme = (ROOT / "README.md").read_text()
    return ("Metadata-Version: 2.1\nName: waymark\n"
            f"Version: {_version()}\n"
            "Summary: From English route instructions to certified routes through linear temporal logic\n"
            "License: MIT\nRequires-Python: >=3.9\nRequires-Dist: numpy\nProvides-Extra: gym\n"
            "Requires-Dist: gymnasium; extra == 'gym'\nDescription-Content-Type: text/markdown\n\n" + readme)


def _wheel_file():
    return f"Wheel-Version: 1.0\nGenerator: waymark_build\nRoot-Is-Purelib: false\nTag: {_tag()}\n"


def _build(stage):
    """Builds, and installs the component `python` below the folder `stage`."""
    given = os.environ.get("WAYMARK_BUILD_DIR")
    tree = Path(given) if given else ROOT / "build" / "python"
    if not given:
        subprocess.run(["cmake", "--preset", "python", "-S", str(ROOT), f"-DPython_EXECUTABLE={sys.executable}",
                        *shlex.split(os.environ.get("CMAKE_ARGS", ""))], cwd=ROOT, check=True)
    subprocess.run(["cmake", "--build", str(tree), "--target", "waymark_python", "waymark-layout"], check=True)
    subprocess.run(["cmake", "--install", str(tree), "--component", "python", "--strip", "--prefix", str(stage)],
                   check=True)
    found = list(stage.rglob("waymark/__init__.py"))
    if len(found) != 1:
        raise RuntimeError(f"the Python module is not in {tree}: what does CMake say of WAYMARK_WITH_PYTHON?")
    return found[0].parent


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    name = f"waymark-{_version()}-{_tag()}.whl"
    info = f"waymark-{_version()}.dist-info"
    record = []
    with tempfile.TemporaryDirectory() as stage, zipfile.ZipFile(Path(wheel_directory) / name, "w",
                                                                 zipfile.ZIP_DEFLATED) as wheel:
        def add(path, content, mode=0o644):
            entry = zipfile.ZipInfo(path, TIME)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o100000 | mode) << 16
            wheel.writestr(entry, content)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            record.append(f"{path},sha256={digest},{len(content)}")

        package = _build(Path(stage))
        for file in sorted(path for path in package.rglob("*") if path.is_file()):
            mode = 0o755 if os.access(file, os.X_OK) else 0o644
            add("waymark/" + file.relative_to(package).as_posix(), file.read_bytes(), mode)
        add(info + "/LICENSE", (ROOT / "LICENSE").read_bytes())
        add(info + "/METADATA", _metadata().encode())
        add(info + "/WHEEL", _wheel_file().encode())
        entry = zipfile.ZipInfo(info + "/RECORD", TIME)
        entry.external_attr = 0o100644 << 16
        wheel.writestr(entry, "\n".join(record + [f"{info}/RECORD,,"]) + "\n")
    return name


def build_sdist(sdist_directory, config_settings=None):
    """The files that git knows of, as a source archive."""
    base = f"waymark-{_version()}"
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, stdout=subprocess.PIPE).stdout
    with tarfile.open(Path(sdist_directory) / f"{base}.tar.gz", "w:gz") as archive:
        for path in filter(None, listed.decode().split("\0")):
            archive.add(ROOT / path, f"{base}/{path}")
        with tempfile.NamedTemporaryFile() as metadata:
            metadata.write(_metadata().encode())
            metadata.flush()
            archive.add(metadata.name, f"{base}/PKG-INFO")
    return f"{base}.tar.gz"
