#!/usr/bin/env python3
"""Every fuzz target for so many minutes of processor time, one after the other, and again from where it was stopped.

minutes.py DIRECTORY_OF_PROGRAMS [--kept FOLDER] [--minutes N] [--chunk SECONDS] [READER...]

A target runs in chunks over one corpus, each with the next seed, until its chunks took N minutes of processor time
together; a busy machine makes the run longer, not smaller. FOLDER/log.jsonl gets a line for each chunk and is read at
the start: a second call does what is left. An input is slow when it takes 5 s of processor time in a run of its own:
libFuzzer's clock also counts when the process is not running. Ends 1 when something was found; a target with a finding
is left, and its input is in FOLDER/READER. `--table` prints what the log says.
"""
import argparse
import json
import os
import re
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
READERS = ("http model formula hoa prism jani planning_case corpus map trajectory commands transition_system roads "
           "letters motion vectors release").split()
SLOW = 5  # seconds of processor time
LIMITS = ["-timeout=120", "-rss_limit_mb=1024", "-malloc_limit_mb=512"]
# The studio asks Graphviz, in a helper executable which leaks what the sanitized tests suppress, too.
LEAKS = {"LSAN_OPTIONS": f"suppressions={HERE.parent / 'support' / 'leaks.supp'}:print_suppressions=0"}


def finished(command, log):
    """Exit code and seconds of processor time, those of the kernel among them."""
    with open(log, "wb") as out:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT,
                                   env=os.environ | LEAKS)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime, usage.ru_stime


def lines(log):
    return [json.loads(line) for line in log.read_text().splitlines()] if log.exists() else []


class Target:
    def __init__(self, options, reader):
        self.reader, self.program = reader, (options.programs / f"fuzz_{reader}").resolve()
        self.folder, self.log = options.kept / reader, options.kept / "log.jsonl"
        self.chunk, self.seconds = options.chunk, options.minutes * 60
        (self.folder / "corpus").mkdir(parents=True, exist_ok=True)

    def chunks(self):
        return [line for line in lines(self.log) if line["target"] == self.reader]

    def confirmed(self):
        """The inputs that were kept and are wrong when they run alone; a slow one that is not is removed."""
        found = []
        for kept in sorted(file for file in self.folder.iterdir() if "-" in file.name):
            code, user, system = finished([self.program, *LIMITS, kept], self.folder / "alone")
            if kept.name.startswith(("timeout-", "slow-unit-")) and code == 0 and user + system < SLOW:
                kept.unlink()
            else:
                found.append(kept.name)
        return found

    def step(self):
        """One chunk; what it found."""
        seed = len(self.chunks()) + 1
        command = [self.program, f"-max_total_time={self.chunk}", f"-seed={seed}", f"-report_slow_units={SLOW}",
                   "-print_final_stats=1", f"-artifact_prefix={self.folder}/", *LIMITS]
        dictionary = HERE / "dictionaries" / f"{self.reader}.dict"
        command += [f"-dict={dictionary}"] if dictionary.exists() else []
        began = time.time()
        code, user, system = finished([*command, self.folder / "corpus", HERE / "seeds" / self.reader],
                                      self.folder / "said")
        said = (self.folder / "said").read_text(errors="replace")
        inputs = re.findall(r"^stat::number_of_executed_units: *(\d+)", said, re.M)
        covered = re.findall(r"\bcov: (\d+)", said)
        found = self.confirmed()
        if code != 0 and not found and "timeout" not in said:
            found = [f"exit code {code}"]
        line = {"target": self.reader, "seed": seed, "user": round(user, 2), "system": round(system, 2),
                "wall": round(time.time() - began, 1), "inputs": int(inputs[-1]) if inputs else 0,
                "edges": int(covered[-1]) if covered else 0, "code": code, "found": found}
        with open(self.log, "a") as log:
            log.write(json.dumps(line) + "\n")
        return found

    def run(self):
        while sum(line["user"] for line in self.chunks()) < self.seconds:
            if found := self.step():
                print(f"{self.reader}: FOUND {', '.join(found)} in {self.folder}", flush=True)
                return False
        return True


def table(log):
    rows = {}
    for line in lines(log):
        rows.setdefault(line["target"], []).append(line)
    print("| target | CPU minutes | inputs | edges | found |\n|---|---|---|---|---|")
    for target, chunks in rows.items():
        user, inputs = sum(chunk["user"] for chunk in chunks), sum(chunk["inputs"] for chunk in chunks)
        found = sorted({name for chunk in chunks for name in chunk["found"]})
        print(f"| `{target}` | {user / 60:.1f} | {inputs:,} | {max(chunk['edges'] for chunk in chunks):,} | "
              f"{', '.join(found) or 'nothing'} |")


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("programs", type=Path, metavar="DIRECTORY_OF_PROGRAMS")
    options.add_argument("readers", nargs="*", metavar="READER")
    options.add_argument("--kept", type=Path, metavar="FOLDER", help="[DIRECTORY_OF_PROGRAMS/findings/minutes]")
    options.add_argument("--minutes", type=float, default=30, metavar="N", help="of processor time, each [30]")
    options.add_argument("--chunk", type=int, default=120, metavar="SECONDS", help="of one run of a target [120]")
    options.add_argument("--table", action="store_true", help="only print what was done")
    given = options.parse_intermixed_args()
    given.kept = (given.kept or given.programs / "findings" / "minutes").resolve()
    given.kept.mkdir(parents=True, exist_ok=True)
    if given.table:
        return table(given.kept / "log.jsonl")
    outcomes = [Target(given, reader).run() for reader in given.readers or READERS]
    return 0 if all(outcomes) else 1


if __name__ == "__main__":
    sys.exit(main())
