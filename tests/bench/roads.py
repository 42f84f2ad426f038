"""Landmarks in order past areas to avoid, on roads of a country: by a hierarchy, without one, and on the product.

roads.py WAYMARK [--nodes N,N,…] [--tasks N] [--seed S] [--rounds N] [--product N] [--folder DIR]

A country is drawn by `waymark generate roads` and preprocessed. A task goes to six landmarks in a random order and
avoids x all the way, `!x U (a & (!x U (b & …)))`; every other task also stays out of y from its third landmark on.
Each task is planned with the hierarchy in a file, after reading the roads alone, and, where the country has no more
nodes than --product says, once by Dijkstra over the product with the same roads as an explicit model. Values must be
equal. Of the rounds of a task the fastest counts; prints the median and the greatest of the tasks. Seconds of a task
are wall-clock seconds after loading, formula to certified route; bytes are the greatest resident size of the whole
process (VmHWM) for each node.
"""
import argparse
import json
import os
import random
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path


def run(command):
    """Standard output, wall-clock seconds, and bytes of the greatest resident size."""
    begun = time.monotonic()
    child = subprocess.Popen(command, stdout=subprocess.PIPE)
    text = child.stdout.read()
    _, status, used = os.wait4(child.pid, 0)
    child.returncode = status
    if status != 0:
        sys.exit(f"{' '.join(command)}: exit {status >> 8}")
    return text, time.monotonic() - begun, used.ru_maxrss * 1024


def task(rng, number):
    order = rng.sample("abcdef", 6)
    formula = ""
    for place, landmark in reversed(list(enumerate(order))):
        avoided = "!x & !y" if number % 2 == 1 and place >= 2 else "!x"
        formula = f"({avoided}) U ({landmark}{' & (' + formula + ')' if formula else ''})"
    return formula


def planned(waymark, roads, formula, *options):
    text, wall, peak = run([waymark, "plan", "--model", roads, "--query", "steps", formula, "--json", *options])
    return json.loads(text), wall, peak


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("waymark")
    options.add_argument("--nodes", default="1000000,10000000")
    options.add_argument("--tasks", type=int, default=6)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--rounds", type=int, default=3)
    options.add_argument("--product", type=int, default=1_000_000)
    options.add_argument("--folder")
    chosen = options.parse_args()
    print("| nodes | way | loading, s | task, s | greatest | nodes met | bytes a node |\n"
          "|---:|:---|---:|---:|---:|---:|---:|")
    with tempfile.TemporaryDirectory() as folder:
        for nodes in map(int, chosen.nodes.split(",")):
            measure(chosen, nodes, Path(chosen.folder or folder) / f"country{nodes}")


def measure(chosen, nodes, prefix):
    roads, hierarchy = f"{prefix}.gr", f"{prefix}.ch"
    run([chosen.waymark, "generate", "roads", "--nodes", str(nodes), "--seed", str(chosen.seed), "--out", str(prefix)])
    text, wall, peak = run([chosen.waymark, "preprocess", roads, "--out", hierarchy, "--json"])
    made = json.loads(text)
    print(f"| {nodes:,} | preprocess, once: {made['hierarchy_arcs']:,} arcs, core {made['core']:,} "
          f"| {made['seconds']['read']:.2f} | {made['seconds']['contract']:.1f} | – | – | {peak / nodes:.0f} |",
          flush=True)
    rng = random.Random(chosen.seed)
    ways = {"hierarchy in a file": ["--hierarchy", hierarchy], "roads alone": []}
    if nodes <= chosen.product:
        ways["Dijkstra over the product"] = ["--hierarchy", "none"]
    rows = {way: [] for way in ways}
    for number in range(chosen.tasks):
        formula = task(rng, number)
        values = set()
        best = {}
        for turn in range(chosen.rounds):
            for way, arguments in ways.items():
                if arguments == ["--hierarchy", "none"] and turn > 0:
                    continue
                answer, wall, peak = planned(chosen.waymark, roads, formula, *arguments)
                values.add((answer["status"], answer["value"]))
                seconds = answer["seconds"]
                solving = seconds["automaton"] + seconds["product"] + seconds["solve"]
                loading = wall - solving
                if "roads" in answer:
                    solving = answer["roads"]["seconds"]["task"]
                    loading = answer["roads"]["seconds"]["read"] + answer["roads"]["seconds"]["hierarchy"]
                row = (loading, solving, answer["product_states"], peak / nodes)
                best[way] = tuple(map(min, row, best.get(way, row)))
        if len(values) != 1:
            sys.exit(f"{formula}: the values differ: {values}")
        for way, row in best.items():
            rows[way].append(row)
    for way, taken in rows.items():
        loading, solving, met, peak = zip(*taken)
        print(f"| {nodes:,} | {way} | {statistics.median(loading):.2f} | {statistics.median(solving):.4f} "
              f"| {max(solving):.4f} | {statistics.median(met):,.0f} | {max(peak):.0f} |", flush=True)


main()
