"""Planning where moves may slip: seconds of a whole case, on one thread and on all, medians of rounds that take turns.

noisy_grids.py WAYMARK [--side N] [--rounds N] [--only FAMILY]

A family is a kind of map with its tasks, all of which are solved with proved bounds: rooms, scattered obstacles, two
halves and a bridge, rooms with one-way doors (no noise), and a bridge between lava (tests/claims/passage.py). Prints
seconds of processor time on one thread, wall-clock seconds on one and on all, their ratio, and the tasks that were not
solved. Values are compared: they are the same to the last digit that is printed.
"""
import argparse
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

PASSAGE = Path(__file__).resolve().parent.parent / "claims" / "passage.py"
FAMILIES = {
    "rooms, noise 0.1": ["--kind", "rooms", "--noise", "0.1", "--landmarks", "4"],
    "scatter, noise 0.05": ["--kind", "scatter", "--noise", "0.05", "--landmarks", "4"],
    "bridge, noise 0.05": ["--kind", "bridge", "--noise", "0.05", "--landmarks", "4"],
    "one-way doors, no noise": ["--kind", "oneway", "--landmarks", "5"],
    "lava, width 2, noise 0.05": ["2", "0.05"],
    "lava, width 1, noise 0.1": ["1", "0.1"],
}


def written(waymark, arguments, side, folder):
    """The case of a family, those of `generate map` with seed 1 unless they say another."""
    if not arguments[0].startswith("-"):
        command = [sys.executable, "-B", str(PASSAGE), str(side), *arguments]
    else:
        seed = [] if "--seed" in arguments else ["--seed", "1"]
        size = ["--width", str(side), "--height", str(side)]
        command = [waymark, "generate", "map", *arguments, *size, *seed, "--tasks"]
    case = folder / "case.json"
    case.write_bytes(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)
    return case


def solved(waymark, case, threads):
    """Wall-clock seconds, seconds of processors, and the answers."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    begun = time.monotonic()
    made = subprocess.run([waymark, "plan", "--case", str(case), "--threads", str(threads)], stdout=subprocess.PIPE)
    wall = time.monotonic() - begun
    now = resource.getrusage(resource.RUSAGE_CHILDREN)
    return wall, now.ru_utime - used.ru_utime, made.stdout


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("waymark")
    options.add_argument("--side", type=int, default=100)
    options.add_argument("--rounds", type=int, default=5)
    options.add_argument("--only", choices=FAMILIES)
    chosen = options.parse_args()
    cores = os.cpu_count()
    print(f"| {chosen.side} x {chosen.side} | user s, 1 thread | wall s, 1 thread | wall s, {cores} threads | ratio "
          "| not solved |\n|---|---:|---:|---:|---:|---:|")
    with tempfile.TemporaryDirectory() as folder:
        for family in [chosen.only] if chosen.only else FAMILIES:
            case = written(chosen.waymark, FAMILIES[family], chosen.side, Path(folder))
            runs = {threads: [] for threads in (1, cores)}
            for _ in range(chosen.rounds):
                for threads, taken in runs.items():
                    taken.append(solved(chosen.waymark, case, threads))
            answers = {answer for taken in runs.values() for _, _, answer in taken}
            if len(answers) != 1:
                sys.exit(f"{family}: the answers differ")
            one, all_ = (statistics.median(wall for wall, _, _ in runs[threads]) for threads in (1, cores))
            user = statistics.median(used for _, used, _ in runs[1])
            print(f"| {family} | {user:.2f} | {one:.2f} | {all_:.2f} | {one / all_:.2f} "
                  f"| {answers.pop().count(b'gave up')} |", flush=True)


if __name__ == "__main__":
    main()
