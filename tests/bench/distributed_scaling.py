"""Strong and weak scaling of `mpirun … waymark plan --case`, and a model of its communication: tables of
docs/scaling.md.

distributed_scaling.py DIRECTORY_OF_PROGRAMS [--side N] [--rounds N] [--latency S] [--bandwidth B] [--cores N]

A solve prepares for S seconds on one rank (the product, the sets, the order of unknowns), and has R rounds. In each, a
rank makes updates of t seconds, then waits for the rank with the most, and exchanges b bytes in α + β b seconds. With L
the sum over the rounds of the most updates of a rank, and U all updates:

    T(n) = S k / n + max(L(n), U(n) / cores) t + R(n) (α + β b),    k = n / min(n, cores), ranks on a core

S and t are measured on one rank; α and β are fitted to two ranks on maps of several widths, of eight rows, by the least
that a rank spent in exchanges and reductions in 3 N runs: there least of the other's work is waited for. Counts, R, L,
U and b, are the run's own; for 64 nodes they are lines through those at 1, 2 and 4 ranks (L · n in place of L). That
prediction takes --latency and --bandwidth of a network, which are assumed and not measured, and log₂ n latencies for
the reduction.
"""
import argparse
import json
import math
import os
import statistics
import subprocess
import tempfile
from pathlib import Path

RANKS = (1, 2, 4)
NODES = 64


def line(points):
    """Least squares: intercept and slope."""
    xs, ys = zip(*points)
    mean_x, mean_y = statistics.mean(xs), statistics.mean(ys)
    spread = sum((x - mean_x) ** 2 for x in xs)
    slope = sum((x - mean_x) * (y - mean_y) for x, y in points) / spread
    return mean_y - slope * mean_x, slope


class Runs:
    def __init__(self, options, folder):
        self.waymark, self.folder, self.rounds = str(options.programs.resolve() / "waymark"), folder, options.rounds
        self.environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}

    def case(self, width, height):
        file = self.folder / f"{width}x{height}.json"
        if not file.exists():
            with open(file, "wb") as out:
                subprocess.run([self.waymark, "generate", "map", "--kind", "scatter", "--width", str(width), "--height",
                                str(height), "--landmarks", "3", "--noise", "0.1", "--seed", "7", "--tasks"],
                               stdout=out,
                               check=True)
        return file

    def run(self, file, ranks):
        """By rank, of the run with the median time: what --statistics says."""
        found = self.all(file, ranks, self.rounds)
        return sorted(found, key=lambda rows: rows[0]["solve_seconds"])[len(found) // 2]

    def all(self, file, ranks, rounds):
        found = []
        for _ in range(rounds):
            subprocess.run(["mpirun", "--oversubscribe", "-np", str(ranks), self.waymark, "plan", "--case", str(file),
                            "--task", "seq", "--statistics", str(self.folder / "done")], stdout=subprocess.DEVNULL,
                           env=self.environment, check=True)
            found.append([json.loads(text) for text in (self.folder / "done").read_text().splitlines()])
        return found


def total(rows, key):
    return sum(row[key] for row in rows)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("programs", type=Path)
    options.add_argument("--side", type=int, default=400, help="of the map of strong scaling [400]")
    options.add_argument("--rounds", type=int, default=3)
    options.add_argument("--latency", type=float, default=2e-6, help="of the assumed network, seconds [2e-6]")
    options.add_argument("--bandwidth", type=float, default=12.5e9, help="of it, bytes a second [12.5e9]")
    options.add_argument("--cores", type=int, default=os.cpu_count())
    options = options.parse_args()
    with tempfile.TemporaryDirectory() as name:
        runs = Runs(options, Path(name))
        points = []
        for width in (200, 800, 1600, 3200):
            every = runs.all(runs.case(width, 8), 2, 3 * options.rounds)
            rows = every[0]
            spent = min(row["exchanging_seconds"] + row["agreeing_seconds"] for rows in every for row in rows)
            points.append((8 * rows[0]["values_received"] / rows[0]["rounds"], spent / rows[0]["rounds"]))
        alpha, beta = line(points)
        print(f"alpha {alpha * 1e6:.2f} µs, beta {beta * 1e9:.3f} ns a byte")
        side = options.side
        for kind, height_of in (("strong", lambda n: side), ("weak", lambda n: side // 4 * n)):
            measured = {n: runs.run(runs.case(side, height_of(n)), n) for n in RANKS}
            one = measured[1][0]
            unit = one["sweeping_seconds"] / one["updates"]
            spent = sum(one[key] for key in ("sweeping_seconds", "exchanging_seconds", "agreeing_seconds"))
            prepared = (one["solve_seconds"] - spent) / one["unknowns"]
            print(f"{kind}: t {unit * 1e9:.2f} ns an update, S {prepared * 1e9:.0f} ns an unknown")
            print("| map | ranks | unknowns | rounds | updates | longest | seconds | predicted | exchange, s "
                  "| work, s |")
            for n, rows in measured.items():
                values = max(row["values_received"] for row in rows)
                rounds = rows[0]["rounds"]
                updates, longest = total(rows, "updates"), rows[0]["longest_updates"]
                work = max(longest, updates / options.cores) * unit
                work += prepared * total(rows, "unknowns") / min(n, options.cores)
                exchange = 0 if n == 1 else rounds * alpha + 8 * values * beta
                print(f"| {side} × {height_of(n)} | {n} | {total(rows, 'unknowns'):.0f} | {rounds:.0f} | "
                      f"{updates:.3g} | {longest:.3g} | {rows[0]['solve_seconds']:.2f} | {work + exchange:.2f} | "
                      f"{statistics.mean(r['exchanging_seconds'] + r['agreeing_seconds'] for r in rows):.2f} | "
                      f"{statistics.mean(r['sweeping_seconds'] for r in rows):.2f} |")
            rounds_0, rounds_1 = line([(n, rows[0]["rounds"]) for n, rows in measured.items()])
            updates_0, updates_1 = line([(n, n * rows[0]["longest_updates"]) for n, rows in measured.items()])
            unknowns_0, unknowns_1 = line([(n, total(rows, "unknowns")) for n, rows in measured.items()])
            rounds, updates = rounds_0 + rounds_1 * NODES, updates_0 + updates_1 * NODES
            unknowns = unknowns_0 + unknowns_1 * NODES
            work = (updates * unit + prepared * unknowns) / NODES
            exchange = rounds * (options.latency * (2 + math.log2(NODES)) + 2 * 8 * side / options.bandwidth)
            print(f"| {side} × {height_of(NODES)} | {NODES} | – | {rounds:.0f} | – | {updates / NODES:.3g} | – | "
                  f"{work + exchange:.2f} | {exchange:.4f} | {work:.2f} |")


if __name__ == "__main__":
    main()
