"""Runs pages of docs/first-five-minutes as their readers do: with an installed waymark, in an empty directory.

first_five_minutes.py SOURCE BUILD SCRATCH NAME... [--write] [--table]

Installs BUILD below SCRATCH. In a block ```console, a line that starts with `$ ` begins a command, `> ` continues it,
and the other lines are what it prints. --write writes what is printed into the pages, --table writes the measured times
into the README of the folder. Exit code 1: a page prints something else. Exit code 77: what a page needs was not built.
"""
import difflib
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

BLOCK = re.compile(r"^```console\n(.*?)^```$", re.M | re.S)
COMMAND = re.compile(r"^\$ (.*(?:\n>.*)*)", re.M)
PER_MINUTE_TYPED, PER_MINUTE_READ = 200, 200


def commands_of(block):
    return [re.sub(r"\n> ?", "\n", command) for command in COMMAND.findall(block)]


def printed_by(command, folder, environment):
    result = subprocess.run(["bash", "-c", command], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    text = result.stdout if result.stdout.endswith("\n") or not result.stdout else result.stdout + "\n"
    for pattern, word in ((r"^time  .*", "time SECONDS"), (r"[0-9]+ bytes, [0-9.]+ s:", "SIZE bytes, SECONDS:"),
                          (r"\t([01]|-)\t[0-9]+\.[0-9]+\t", r"\t\1\tSECONDS\t")):
        text = re.sub(pattern, word, text, flags=re.M)
    return text


def rerun(page, folder, environment):
    def block(match):
        shown = ["```console\n"]
        for command in commands_of(match[1]):
            shown.append("$ " + re.sub(r"\n> (?=\n)", "\n>", command.replace("\n", "\n> ")) + "\n")
            shown.append(printed_by(command, folder, environment))
        return "".join(shown) + "```"

    return BLOCK.sub(block, page)


def row_of_table(name, page, seconds):
    commands = [command for block in BLOCK.findall(page) for command in commands_of(block)]
    typed = sum(len(command.splitlines()[0]) for command in commands)  # files are pasted
    read = len(BLOCK.sub("", page).split())
    minutes = typed / PER_MINUTE_TYPED + read / PER_MINUTE_READ + seconds / 60
    title = "Python" if name == "python" else name
    return f"| [{title}]({name}.md) | {len(commands)} | {typed} | {read} | {seconds:.1f} | {minutes:.1f} |"


def main(source, build, scratch, *names):
    options = {name for name in names if name.startswith("--")}
    scratch = Path(scratch).resolve()
    prefix = scratch / "prefix"
    shutil.rmtree(scratch, ignore_errors=True)
    subprocess.run(["cmake", "--install", build, "--prefix", str(prefix)], stdout=subprocess.DEVNULL, check=True)
    module = prefix / "lib/python3/dist-packages"
    of_developers = ("WAYMARK_DATA", "PYTHONPATH", "CMAKE_CXX_COMPILER_LAUNCHER")
    environment = {key: value for key, value in os.environ.items() if key not in of_developers}
    interpreter = scratch / "interpreter"  # `python3` is the one that runs this script
    interpreter.mkdir()
    (interpreter / "python3").symlink_to(sys.executable)
    environment |= {"PATH": f"{interpreter}:{prefix}/bin:{os.environ['PATH']}", "CMAKE_PREFIX_PATH": str(prefix),
                    "LC_ALL": "C.UTF-8", "PYTHONPATH": str(module), "PYTHONDONTWRITEBYTECODE": "1"}
    status = 0
    for name in sorted(set(names) - options):
        file = Path(source) / "docs/first-five-minutes" / f"{name}.md"
        if name == "python" and not (module / "waymark").exists():
            print(f"SKIPPED: {name}: the Python module is not built (-DWAYMARK_WITH_PYTHON=ON, ./dev setup python)")
            status = status or 77
            continue
        clean = scratch / name
        clean.mkdir()
        page, started = file.read_text(), time.monotonic()
        now, seconds = rerun(page, clean, environment), time.monotonic() - started
        print(f"{name}: {len(BLOCK.findall(page))} blocks in {seconds:.1f} s")
        if "--write" in options:
            file.write_text(now)
        elif now != page:
            sys.stdout.writelines(difflib.unified_diff(page.splitlines(True), now.splitlines(True), str(file), "now"))
            status = 1
        if "--table" in options:
            table = file.parent / "README.md"
            row = row_of_table(name, page, seconds)
            table.write_text(re.sub(rf"^\| \[\w+\]\({name}\.md\).*", row, table.read_text(), flags=re.M))
    return status


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
