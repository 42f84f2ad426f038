"""Throughput of a batch on ranks of mpirun, beside one process with as many threads: the table of docs/scaling.md.

scaling.py DIRECTORY_OF_PROGRAMS [--texts N] [--rounds N] [--seed S] [--memory]

Wall-clock seconds and seconds of processors, medians over rounds in which all ways take turns, for one corpus of random
formulas; every output has the bytes of the first. --memory: instead, the most memory that a process of four ranks held.
"""
import argparse
import os
import resource
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

ARGUMENTS = ["--one-line", "--to", "dfa"]


def environment():
    return {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def processors():  # seconds of all processes that have ended
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def ways(waymark):
    found = {f"one process, {n} thread{'s' * (n > 1)}": [waymark, "translate", *ARGUMENTS, "--threads", str(n)]
             for n in (1, 2, 4)}
    for n in (1, 2, 4):
        found[f"mpirun -np {n}"] = ["mpirun", "--oversubscribe", "-np", str(n), waymark, "translate", *ARGUMENTS]
    return found


def most_memory(command, folder):
    """Mebibytes of VmHWM, by program, looked at twenty times a second."""
    most = {}
    with open(folder / "out", "wb") as out:
        process = subprocess.Popen(command, stdout=out, env=environment())
        while process.poll() is None:
            for place in Path("/proc").glob("[0-9]*"):
                try:
                    line = (place / "cmdline").read_bytes().split(b"\0")
                    if str(folder).encode() not in b" ".join(line) or b"waymark" not in line[0]:
                        continue
                    seat = [v for v in (place / "environ").read_bytes().split(b"\0") if v.startswith(b"WAYMARK_FARM=")]
                    name = seat[0].split(b"=")[1].split()[0].decode() if seat else (place / "comm").read_text().strip()
                    status = (place / "status").read_text()
                    held = int(status.split("VmHWM:")[1].split()[0]) / 1024
                    most[name] = max(most.get(name, 0), held)
                except (OSError, IndexError):
                    continue
            time.sleep(0.05)
    return most


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("programs", type=Path)
    options.add_argument("--texts", type=int, default=100_000)
    options.add_argument("--rounds", type=int, default=5)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--memory", action="store_true")
    options = options.parse_args()
    waymark = str(options.programs.resolve() / "waymark")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        corpus = folder / "corpus.ltl"
        with open(corpus, "wb") as file:
            subprocess.run([waymark, "random", "--count", str(options.texts), "--size", "5..12", "--seed",
                            str(options.seed)], stdout=file, check=True)
        if options.memory:
            for seat, held in sorted(most_memory([*ways(waymark)["mpirun -np 4"], "-F", str(corpus)], folder).items()):
                print(f"| {options.texts} | {seat} | {held:.0f} MiB |")
            return
        taken, worked, first = {}, {}, None
        for _ in range(options.rounds):
            for way, command in ways(waymark).items():
                begun, before = time.monotonic(), processors()
                out = subprocess.run([*command, "-F", str(corpus)], stdout=subprocess.PIPE, check=True,
                                     env=environment()).stdout
                taken.setdefault(way, []).append(time.monotonic() - begun)
                worked.setdefault(way, []).append(processors() - before)
                first = first or out
                assert out == first, f"{way}: other bytes"
        for way, seconds in taken.items():
            median = statistics.median(seconds)
            print(f"| {way} | {median:.1f} | {min(seconds):.1f}–{max(seconds):.1f} | {options.texts / median:.0f} | "
                  f"{statistics.median(worked[way]):.1f} |")


if __name__ == "__main__":
    main()
