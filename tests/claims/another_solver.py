#!/usr/bin/env python3
"""Values by another solver: each strategy that waymark writes, as a Markov chain, by SciPy's sparse LU.

another_solver.py WAYMARK [--best] [--only SET] [--side N] [--models N] [--seed S]
another_solver.py WAYMARK [--best] --case FILE...

Sets of tasks: `families` (those of tests/bench/noisy_grids.py, mazes and one-way streets, with more tasks), `passages`
(bridges between lava, the rows of docs/planning.md), `bridges` (its twelve of one side), `large` (its grids of 500 by
500 and of 1000 by 1000 cells), `models` (random Markov decision processes in PRISM's explicit files), `curves` (points
of two objectives of such models).

The chance of winning is that of stopping in an accepting state, or of staying for ever where marked edges recur (bottom
components of the chain, [BK08, Cor. 10.34]); a cost is the expected one until then. What files and strategies mean is
read in chains.py, without code of waymark. Each value must lie between the bounds that waymark gives the strategy
(`re_evaluated`), be no better than its bounds of the best, and no worse by more than the tolerance. Left out are walks
(`cycle`, `lasso`) and values that the graph alone shows to be 0 or infinite: they have no strategy. Exit code 77: SciPy
is missing.

With --best, the best value over all strategies is found by policy iteration (best.py), and must lie between waymark's
bounds; `passages`, `large` and `curves` are not meant for it.
"""
import argparse
import itertools
import json
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "bench")]
try:
    from best import best
    from chains import Chain, Point, model_of, strategies
except ImportError as missing:
    print(f"SKIPPED: {missing}: no value is found by another solver")
    sys.exit(77)
from noisy_grids import FAMILIES, written  # noqa: E402: after the path

INFINITE = float("inf")
TOLERANCE = 1e-6  # of waymark's bounds
ROUNDING = 1e-12
EXACT = 1e-9  # of the best value
DISCOUNT = 0.9
MORE_FAMILIES = {
    "maze, noise 0.1": ["--kind", "maze", "--noise", "0.1", "--landmarks", "3"],
    "one-way streets, noise 0.05": ["--kind", "oneway", "--noise", "0.05", "--landmarks", "3"],
    "lava, width 3, noise 0.02": ["3", "0.02"],
}
MORE_TASKS = [("ltl", "F a", "pmin"), ("ltl", "(!b) U a", "pmin"), ("ltl", "F G !a", "pmin"),
              ("ltl", "(!b) U a", "pmax"), ("ltl", "F G (!a & !b)", "pmax"), ("ltl", "G F a & F G !b", "pmax"),
              ("pctl", "F<=30 a", "pmax"), ("ltl", "F (a & F b)", "rmin"), ("ltl", "F (a & F b)", "discounted")]
PASSAGES = [(50, 1, 0.05), (50, 3, 0.05), (60, 3, 0.15), (100, 2, 0.05), (100, 3, 0.05), (200, 2, 0.05), (200, 3, 0.02),
            (200, 3, 0.2), (300, 3, 0.02), (300, 2, 0.2), (500, 3, 0.02)]
LARGE = [("scatter", 500, 0.1, 3, 7, ["seq", "avoidseq"]), ("scatter", 500, 0.05, 4, 1, ["seq", "avoidseq"]),
         ("rooms", 500, 0.1, 3, 7, ["seq"]), ("rooms", 500, 0.05, 4, 1, ["seq"]), ("maze", 251, 0.2, 2, 5, ["seq"]),
         ("scatter", 500, 0.1, 1, 7, ["seq"]), ("scatter", 1000, 0.05, 4, 1, ["seq", "avoidseq"]),
         ("rooms", 1000, 0.1, 4, 1, ["cover", "patrol"])]
MODEL_TASKS = [("(!x) U a", "pmax"), ("F (a & F b) & G !x", "pmax"), ("G F a & G F b", "pmax"), ("F G !x", "pmax"),
               ("(!x) U a", "pmin"), ("G F x", "pmin"), ("F (a & F b)", "rmin"), ("F (a & F b)", "discounted")]
CURVES = [('multi(Pmax=? [ !"x" U "a" ], R{"cost"}min=? [ C ])', [("x", "a")]),
          ('multi(Pmax=? [ !"x" U "a" ], Pmin=? [ F "b" ])', [("x", "a"), (None, "b")])]


def with_strategies(case, copy, more=()):
    """A copy with more tasks and without those that ask for a walk."""
    document = json.loads(case.read_text())
    document["tasks"] = [task for task in document["tasks"] if task["query"] not in ("cycle", "lasso")]
    document["tasks"] += [{"id": f"more{i}", "logic": logic, "formula": formula, "query": query}
                          for i, (logic, formula, query) in enumerate(more)]
    copy.write_text(json.dumps(document))
    return copy


def farther(value, lower, upper):
    """How far from an interval: relative where values exceed 1."""
    if lower <= value <= upper:
        return 0.0
    return max(lower - value, value - upper) / max(1.0, min(abs(upper), abs(value)))


def random_model(prefix, source, size, ends=False):
    """States in a ring with chords; a choice leads near, and sometimes stays for ever. `ends`: all runs may end in a
    state that costs nothing."""
    rows, labels = [], ['0="init" 1="a" 2="b" 3="x"', "0: 0"]
    for state in range(size):
        for choice in range(source.randint(1, 3)):
            targets = {(state + source.randint(-3, 4)) % size for _ in range(source.randint(1, 3))}
            if source.random() < 0.2:
                targets.add(source.randrange(size))
            if not ends and source.random() < 0.02:
                targets = {state}
            if ends:
                targets.add((state + 1) % size if state + 1 < size else state)
                targets = targets if state + 1 < size else {state}
            weights = [source.randint(1, 20) for _ in targets]
            rows += [f"{state} {choice} {target} {weight / sum(weights)!r} m{choice}"
                     for target, weight in zip(sorted(targets), weights)]
        label = source.choices(["1", "2", "3", ""], [1, 1, 2, 30])[0]
        labels += [f"{state}: {label}"] if label and state else []
    choices = len({tuple(row.split()[:2]) for row in rows})
    prefix.with_suffix(".tra").write_text(f"{size} {choices} {len(rows)}\n" + "\n".join(rows) + "\n")
    prefix.with_suffix(".lab").write_text("\n".join(labels) + "\n")
    rewards = [f"{state} {0 if ends and state + 1 == size else source.randint(1, 9)}" for state in range(size)]
    prefix.with_suffix(".srew").write_text(f"{size} {size}\n" + "\n".join(rewards) + "\n")
    return prefix.with_suffix(".tra")


class Checks:
    def __init__(self, options, folder):
        self.options, self.folder, self.rows, self.set = options, folder, [], ""
        self.file = folder / "strategies"

    def run(self, name, model, arguments):
        """What waymark plans on this model: each value found again."""
        self.file.unlink(missing_ok=True)
        code = subprocess.run([self.options.waymark, "plan", *arguments, "--strategy", self.file, "--discount",
                               str(DISCOUNT)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        if code.returncode not in (0, 1, 10):
            sys.exit(f"error: {name}: {arguments}: exit code {code.returncode}: {code.stderr.decode()}")
        for head, decisions in strategies(self.file) if self.file.exists() else []:
            begun = time.process_time()
            pairs, found = self.found(model, head, decisions)
            self.row(name, head, pairs, found, time.process_time() - begun)

    def found(self, model, head, decisions):
        """How many pairs, and what the strategy is worth."""
        chain = Chain(model, head, decisions)
        kind = {"rmin": "cost", "steps": "cost", "discounted": "discounted"}.get(head["query"], "chance")
        return len(chain.pairs), chain.value(kind, DISCOUNT)

    def judged(self, head, found):
        """How far outside, and whether that is wrong."""
        lower, upper = (float(head[key]) for key in ("lower", "upper"))
        own = [float(head["re_evaluated"][key]) for key in ("lower", "upper")]
        least = head["query"] in ("pmin", "rmin", "steps")
        outside = max(farther(found, *own), farther(found, *((lower, INFINITE) if least else (-INFINITE, upper))))
        return outside, outside > TOLERANCE or farther(found, lower, upper) > 2 * TOLERANCE

    def row(self, name, head, pairs, found, seconds):
        lower, upper = (float(head[key]) for key in ("lower", "upper"))
        outside, wrong = self.judged(head, found)
        self.rows.append((self.set, pairs, outside, wrong))
        print(f"| {name} | `{head['task'] if head['task'] != 'formula' else head['formula']}` | {head['query']} | "
              f"{pairs:,} | {lower:.9g} to {upper:.9g} | {found:.9g} | {outside:.0e} | {seconds:.0f} |", flush=True)

    def families(self):
        for name, arguments in (FAMILIES | MORE_FAMILIES).items():
            case = written(self.options.waymark, arguments, self.options.side | ("maze" in name), self.folder)
            self.run(name, model_of(case), ["--case", with_strategies(case, case, MORE_TASKS)])

    def passages(self):
        for side, width, noise in PASSAGES:
            case = written(self.options.waymark, [str(width), str(noise)], side, self.folder)
            self.run(f"{side}, {width}, {noise}", model_of(case), ["--case", case])

    def bridges(self):
        for width, noise in itertools.product((1, 2, 3), (0.02, 0.05, 0.1, 0.2)):
            case = written(self.options.waymark, [str(width), str(noise)], self.options.side, self.folder)
            self.run(f"{self.options.side}, {width}, {noise}", model_of(case), ["--case", case])

    def large(self):
        for kind, side, noise, landmarks, seed, tasks in LARGE:
            case = written(self.options.waymark, ["--kind", kind, "--noise", str(noise), "--landmarks", str(landmarks),
                                                  "--seed", str(seed)], side, self.folder)
            for task in tasks:
                self.run(f"{kind}, {side}², noise {noise}", model_of(case), ["--case", case, "--task", task])

    def models(self):
        source = random.Random(self.options.seed)
        for _ in range(self.options.models):
            file = random_model(self.folder / "model", source, source.choice([30, 300, 3000]))
            model = model_of(file)
            for formula, query in MODEL_TASKS:
                self.run(f"random, {len(model.choices):,} states", model, [formula, "--model", file, "--query", query])

    def curves(self):
        source = random.Random(self.options.seed)
        for _ in range(self.options.models):
            file = random_model(self.folder / "model", source, source.choice([10, 30, 100]), ends=True)
            model = model_of(file)
            for query, formulas in CURVES:
                begun, before = time.process_time(), len(self.rows)
                properties = self.folder / "properties"
                properties.write_text(query)
                done = subprocess.run([self.options.waymark, "plan", "--model", file, "--properties", properties,
                                       "--json"], stdout=subprocess.PIPE, check=True)
                for found in json.loads(done.stdout)["points"]:
                    point = Point(model, formulas, found["strategy"])
                    values = [point.chance(0), point.chance(1) if len(formulas) > 1 else point.total_cost()]
                    outside = max(farther(value, *own) for value, own in zip(values, found["re_evaluated"]))
                    outside = max(outside, *(farther(value, told - TOLERANCE, told + TOLERANCE)
                                             for value, told in zip(values, found["values"])))
                    self.rows.append((self.set, len(point.pairs), outside, outside > TOLERANCE))
                print(f"| {len(model.choices):,} states | `{query}` | multi | | {len(self.rows) - before} points | | "
                      f"{max((row[2] for row in self.rows[before:]), default=0):.0e} "
                      f"| {time.process_time() - begun:.0f} |", flush=True)

    def cases(self):
        for case in self.options.case:
            self.run(case.stem, model_of(case), ["--case", with_strategies(case, self.folder / "copy.json")])

    def summary(self):
        print("\n| set | values | pairs met, at most | outside by more than 1e-12 | farthest |\n"
              "|---|---:|---:|---:|---:|")
        for name in dict.fromkeys(name for name, *_ in self.rows):
            those = [row for row in self.rows if row[0] == name]
            print(f"| {name} | {len(those)} | {max(row[1] for row in those):,} "
                  f"| {sum(row[2] > ROUNDING for row in those)} | {max(row[2] for row in those):.0e} |")
        wrong = sum(row[3] for row in self.rows)
        print(f"{len(self.rows)} values, {wrong} wrong")
        return 1 if wrong or not self.rows else 0


class Bests(Checks):
    """The bounds of the best strategy hold what policy iteration finds over all strategies."""

    def found(self, model, head, decisions):
        return best(model, head, DISCOUNT)

    def judged(self, head, found):
        outside = farther(found, *(float(head[key]) for key in ("lower", "upper")))
        return outside, outside > EXACT


SETS = {"families": Checks.families, "passages": Checks.passages, "bridges": Checks.bridges,
        "large": Checks.large, "models": Checks.models, "curves": Checks.curves}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("waymark")
    parser.add_argument("--case", type=Path, nargs="+", metavar="FILE", help="planning cases")
    parser.add_argument("--only", choices=SETS, action="append", help="also several times")
    parser.add_argument("--side", type=int, default=100, help="of families and bridges [100]")
    parser.add_argument("--models", type=int, default=30, help="how many at random [30]")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--best", action="store_true", help="the best values instead of those of strategies")
    options = parser.parse_args()
    print("| model | task | query | pairs met | bounds | by the other solver | outside | s |\n"
          "|---|---|---|---:|---|---:|---:|---:|")
    with tempfile.TemporaryDirectory() as folder:
        checks = (Bests if options.best else Checks)(options, Path(folder))
        for name, check in ({"cases": Checks.cases} if options.case else SETS).items():
            if options.case or not options.only or name in options.only:
                checks.set = name
                check(checks)
        return checks.summary()


if __name__ == "__main__":
    sys.exit(main())
