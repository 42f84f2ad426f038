"""Trials of the programs of waymark: how they are started, counted and reported. Shared by the scripts of this folder.

Every script is called as NAME.py DIRECTORY_OF_PROGRAMS [--trials N] [--seed S] …. Exit code 0: no fault. Exit code 1:
a fault, printed with what reproduces it. Exit code 77: nothing could be tried here.
"""
import argparse
import collections
import contextlib
import os
import random
import shlex
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
DONE, NO, GAVE_UP, NOT_UNDERSTOOD, USAGE, BAD_INPUT, DEFECT = 0, 10, 11, 12, 20, 21, 30  # docs/cli.md, exit codes
MOST_SHOWN = 3000  # characters of a stream in a report

Finished = collections.namedtuple("Finished", "code out err seconds")  # code: negative where a signal ended the program


def parser(description, trials):
    options = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("programs", type=Path, metavar="DIRECTORY_OF_PROGRAMS")
    options.add_argument("--trials", type=int, default=trials, metavar="N", help=f"number of trials [{trials}]")
    options.add_argument("--seed", type=int, default=1, metavar="S", help="of everything random [1]")
    options.add_argument("--data", type=Path, default=SOURCE / "data", help="maps and models [those of the sources]")
    options.add_argument("--keep", action="store_true", help="keep the scratch directory after a fault")
    return options


class Programs:
    """The programs of one directory, started with the data of the sources and without colours."""

    def __init__(self, options):
        self.directory, self.data = options.programs.resolve(), options.data.resolve()
        self.environment = {**os.environ, "WAYMARK_DATA": str(self.data), "LC_ALL": "C.UTF-8"}
        self.environment.pop("CLICOLOR_FORCE", None)
        if not (self.directory / "waymark").exists():
            raise SystemExit(f"error: {self.directory} holds no program waymark")

    def has(self, name):
        return (self.directory / name).exists()

    def command(self, arguments):
        return [str(self.directory / "waymark"), *map(str, arguments)]

    def start(self, arguments, folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
              **more):
        return subprocess.Popen(self.command(arguments), cwd=folder, env=self.environment, stdin=stdin, stdout=stdout,
                                stderr=stderr, **more)

    def run(self, arguments, folder, given=b"", seconds=60, **streams):
        """Runs to the end; a program that takes longer than `seconds` is killed and has the code None."""
        streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **streams}
        started = time.monotonic()
        process = self.start(arguments, folder, stdin=subprocess.PIPE if given else subprocess.DEVNULL, **streams)
        try:
            out, err = process.communicate(given or None, timeout=seconds)
            code = process.returncode
        except subprocess.TimeoutExpired:
            process.kill()
            (out, err), code = process.communicate(), None
        return Finished(code, (out or b"").decode(errors="replace"), (err or b"").decode(errors="replace"),
                        time.monotonic() - started)

    def prepare(self, arguments, folder):
        """Runs what has to succeed before anything is tried."""
        result = self.run(arguments, folder, seconds=600)
        if result.code != DONE:
            raise SystemExit(f"error: {self.text(arguments)} ends with {result.code}: {result.err}")
        return result

    def text(self, arguments):
        return shlex.join(self.command(arguments))


class Trials:
    """Counts what happened, and prints faults as they are found."""

    def __init__(self, name, options):
        self.name, self.options = name, options
        self.counts, self.seconds = collections.Counter(), collections.Counter()
        self.faults = 0
        self.most_faults = 20
        self.started = time.monotonic()
        self.folders = []

    def random(self, trial):
        return random.Random(f"{self.options.seed}:{trial}")

    @contextlib.contextmanager
    def scratch(self):
        folder = Path(tempfile.mkdtemp(prefix=f"waymark-{self.name}-"))
        try:
            yield folder
        finally:
            if self.faults and self.options.keep:
                print(f"kept: {folder}")
            else:
                shutil.rmtree(folder, ignore_errors=True)

    def fault(self, why, command, **facts):
        """A fault with its reproduction. Ends the script when there are too many to read."""
        self.faults += 1
        print(f"FAULT {self.faults} of {self.name} (--seed {self.options.seed}): {why}\n  command: {command}")
        for key, value in facts.items():
            value = str(value)
            print(f"  {key}: {value[:MOST_SHOWN]}{' …' if len(value) > MOST_SHOWN else ''}")
        if self.faults >= self.most_faults:
            print("Too many faults: the rest is not tried.")
            raise SystemExit(self.end())

    def end(self):
        for key, count in sorted(self.counts.items(), key=lambda row: str(row[0])):
            print(f"  {count:7}  {key}")
        seconds = time.monotonic() - self.started
        print(f"{self.name}: {self.faults} faults, seed {self.options.seed}, {seconds:.1f} s")
        return 1 if self.faults else 0
