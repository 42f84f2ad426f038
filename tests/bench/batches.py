"""Batches on one thread and on all: medians of rounds that take turns, and the same bytes.

batches.py WAYMARK [--rounds N]

Formulas are random (seed 1): 3,000 to automata, 7,000 small ones over the places of the map `grid` to products and
routes, whose answers tell no times (`--json` without them is compared).
"""
import argparse
import json
import os
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

PLACES = {"p0": "chair", "p1": "sofa", "p2": "blue", "p3": "lamp"}
LARGE = ["random", "--props", "4", "--size", "15..30", "--count", "3000", "--seed", "1"]
SMALL = ["random", "--props", "4", "--size", "4..9", "--count", "7000", "--seed", "1", "--semantics", "finite"]
BATCHES = {
    "translate --to tgba": "large",
    "translate --to parity": "large",
    "compose --format dot --map grid": "small",
    "plan --json --map grid": "small",
}


def timeless(answers):
    """Answers without the seconds that they took."""
    lines = []
    for line in answers.splitlines():
        if line.startswith(b"{"):
            answer = json.loads(line)
            for key in [key for key in answer if "ms" in key or "seconds" in key or "mib" in key]:
                del answer[key]
            lines.append(json.dumps(answer))
        else:
            lines.append(line)
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("waymark")
    parser.add_argument("--rounds", type=int, default=5)
    options = parser.parse_args()
    cores = os.cpu_count()
    print(f"| batch | s, 1 thread | s, {cores} threads | ratio |\n|---|---:|---:|---:|")
    with tempfile.TemporaryDirectory() as folder:
        for name, drawn in (("large", LARGE), ("small", SMALL)):
            text = subprocess.run([options.waymark, *drawn], check=True, capture_output=True, text=True).stdout
            for proposition, place in PLACES.items() if name == "small" else ():
                text = text.replace(proposition, place)
            (Path(folder) / name).write_text(text)
        for batch, corpus in BATCHES.items():
            seconds, answers = {1: [], cores: []}, {}
            for _ in range(options.rounds):
                for threads, taken in seconds.items():
                    begun = time.monotonic()
                    made = subprocess.run([options.waymark, *batch.split(), "-F", Path(folder) / corpus, "--threads",
                                           str(threads)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
                    taken.append(time.monotonic() - begun)
                    answers[threads] = timeless(made.stdout)
            if answers[1] != answers[cores]:
                raise SystemExit(f"{batch}: the answers differ")
            one, all_ = statistics.median(seconds[1]), statistics.median(seconds[cores])
            print(f"| `{batch}` | {one:.3f} | {all_:.3f} | {one / all_:.2f} |", flush=True)


main()
