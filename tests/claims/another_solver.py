#!/usr/bin/env python3
"""Values of noisy grids by another solver: each strategy that waymark writes, as a Markov chain, by SciPy's sparse LU.

another_solver.py WAYMARK [--side N] [--seed S]

The families are those of tests/bench/noisy_grids.py, and noisy mazes and one-way streets. What a case, an automaton and
a strategy mean is read here from the documented formats alone; no code of waymark takes part. The chance of winning is
that of stopping in an accepting state, or of staying for ever where marked edges recur (bottom components of the chain,
[BK08, Cor. 10.34]); a cost is the expected number of moves until then. Each must lie between the bounds that waymark
gives, up to its tolerance. Exit code 77: SciPy is missing.
"""
import argparse
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import numpy
    from scipy.sparse import coo_matrix, csr_matrix, identity
    from scipy.sparse.csgraph import connected_components
    from scipy.sparse.linalg import splu
except ImportError:
    print("SKIPPED: scipy is not installed: no value is found by another solver")
    sys.exit(77)

PASSAGE = Path(__file__).resolve().parent / "passage.py"
KINDS = {
    "rooms, noise 0.1": ["rooms", "0.1"],
    "scatter, noise 0.05": ["scatter", "0.05"],
    "bridge, noise 0.05": ["bridge", "0.05"],
    "maze, noise 0.1": ["maze", "0.1"],
    "one-way streets, noise 0.05": ["oneway", "0.05"],
    "lava, width 2, noise 0.05": ["2", "0.05"],
    "lava, width 1, noise 0.1": ["1", "0.1"],
    "lava, width 3, noise 0.02": ["3", "0.02"],
}
DIRECTIONS = "NESW"
STEPS = [(0, -1), (1, 0), (0, 1), (-1, 0)]
TOLERANCE = 1e-6  # of waymark's bounds


class Automaton:
    """A deterministic one of the Hanoi format, Büchi: next(state, letter) and which edges are marked."""

    def __init__(self, text):
        head, body = text.split("--BODY--")
        self.names = re.findall(r'"([^"]*)"', re.search(r"AP: \d+((?: \"[^\"]*\")*)", head)[1])
        self.start = int(re.search(r"Start: (\d+)", head)[1])
        self.finite = "finite-words" in head
        if "acc-name: Buchi" not in head:
            raise SystemExit(f"error: not a Büchi automaton: {head}")
        self.marked, self.edges, self.known = set(), {}, {}
        for state, mark, edges in re.findall(r"State: (\d+)( \{0\})?((?: *\[[^]]*\] \d+(?: \{0\})?)*)", body):
            self.marked.update([int(state)] if mark else [])
            self.edges[int(state)] = [(self.condition(label), int(target), bool(edge_mark)) for label, target, edge_mark
                                      in re.findall(r"\[([^]]*)\] (\d+)( \{0\})?", edges)]

    @staticmethod
    def condition(label):
        if label == "t":
            return "True"
        return re.sub(r"\d+", lambda n: f"v[{n[0]}]", label.replace("!", " not ").replace("&", " and ")
                      .replace("|", " or ")).strip()

    def next(self, state, letter):
        """The next state, and whether the edge is marked; (None, False) when there is no edge."""
        if (state, letter) not in self.known:
            v = [name in letter for name in self.names]
            fits = [(target, mark) for condition, target, mark in self.edges[state] if eval(condition, {"v": v})]
            if len(fits) > 1:
                raise SystemExit("error: the automaton is not deterministic")
            target, mark = fits[0] if fits else (None, False)
            self.known[state, letter] = (target, bool(mark or state in self.marked))
        return self.known[state, letter]


class Grid:
    """Where a move may lead, from `ltlgrid/1`."""

    def __init__(self, case):
        self.rows, self.legend = case["rows"], {".": {}, **case["legend"]}
        self.start = (case["start"]["x"], case["start"]["y"])
        motion = case.get("motion", {"forward": 1})
        self.chances = [motion.get(key, 0) for key in ("forward", "right", "back", "left")]
        self.cost = case.get("cost", {}).get("step", 1)

    def cell(self, at):
        x, y = at
        inside = 0 <= y < len(self.rows) and 0 <= x < len(self.rows[y])
        return self.legend[self.rows[y][x]] if inside else {"wall": True}

    def letter(self, at):
        return frozenset(self.cell(at).get("props", []))

    def moved(self, at, direction):
        to = (at[0] + STEPS[direction][0], at[1] + STEPS[direction][1])
        ways = (self.cell(at).get("oneway"), self.cell(to).get("oneway"))
        barred = self.cell(to).get("wall") or any(way and way != DIRECTIONS[direction] for way in ways)
        return at if barred else to

    def outcomes(self, at, action):
        return [(self.moved(at, (action + turn) % 4), p) for turn, p in enumerate(self.chances) if p > 0]


class Chain:
    """The pairs that a strategy meets, from the start on; where it says nothing, any move is as good."""

    def __init__(self, grid, head, decisions):
        automaton = Automaton(head["automaton"])
        self.number, self.edges, self.goals, marks = {}, [], [], []
        chosen = {(tuple(map(int, d["state"].split(","))), d["task"]): d for d in decisions}
        first, _ = automaton.next(automaton.start, grid.letter(grid.start))
        if (grid.start, first) not in chosen and (grid.start, automaton.start) in chosen:
            raise SystemExit("error: a strategy that begins before the first letter")
        self.meet((grid.start, first))
        for pair in (pairs := list(self.number)):
            at, state = pair
            source, decision = self.number[pair], chosen.get(pair)
            if state is None or (automaton.finite and state in automaton.marked and not decision):
                self.goals += [source] if state is not None else []
                self.edges.append((source, source, 1.0))
            elif decision and "jump" in decision:
                self.add(source, (at, decision["jump"]), 1.0, pairs)
            else:
                for to, p in grid.outcomes(at, DIRECTIONS.index(decision["action"]) if decision else 0):
                    target, mark = automaton.next(state, grid.letter(to))
                    self.add(source, (to, target), p, pairs)
                    marks += [source] if mark else []
        self.matrix = self.summed()
        self.goals = sorted({*self.goals, *self.recurrent(set(marks))})

    def meet(self, pair):
        return self.number.setdefault(pair, len(self.number))

    def add(self, source, pair, p, pairs):
        if pair not in self.number:
            pairs.append(pair)
        self.edges.append((source, self.meet(pair), p))

    def summed(self):
        rows, columns, chances = zip(*self.edges)
        return csr_matrix(coo_matrix((chances, (rows, columns)), shape=(len(self.number),) * 2))

    def recurrent(self, marked):
        """Pairs of bottom components with a marked edge."""
        count, of = connected_components(self.matrix, connection="strong")
        leaves, wins = numpy.zeros(count, bool), numpy.zeros(count, bool)
        rows, columns = self.matrix.nonzero()
        leaves[of[rows[of[rows] != of[columns]]]] = True
        wins[of[list(marked)]] = True
        return numpy.flatnonzero((wins & ~leaves)[of]).tolist()

    def reaching(self, targets):
        """Which pairs may reach these."""
        backwards, reached, open_ = csr_matrix(self.matrix.T), set(targets), list(targets)
        while open_:
            row = open_.pop()
            for source in backwards.indices[backwards.indptr[row]:backwards.indptr[row + 1]]:
                if source not in reached:
                    reached.add(source)
                    open_.append(source)
        return reached

    def value(self, cost):
        """From the start: the chance to win, or with a cost a move the expected cost until then."""
        pairs, won = range(len(self.number)), set(self.goals)
        some = self.reaching(won)
        lost = set(pairs) - some
        if cost is None:
            won = set(pairs) - self.reaching(lost)  # almost surely
        elif lost:
            return numpy.inf
        if 0 in won or 0 in lost:
            return 1.0 if cost is None and 0 in won else 0.0
        unknown = sorted(some - won)
        kept = self.matrix[unknown]
        system = (identity(len(unknown)) - kept[:, unknown]).tocsc()
        known = kept[:, sorted(won)].sum(axis=1).A1 if cost is None else numpy.full(len(unknown), float(cost))
        factors = splu(system)
        found = factors.solve(known)
        found += factors.solve(known - system @ found)  # one step of refinement
        return found[unknown.index(0)]


def case_of(options, kind):
    if kind.startswith("lava"):
        command = [sys.executable, "-B", str(PASSAGE), str(options.side), *KINDS[kind]]
    else:
        name, noise = KINDS[kind]
        command = [options.waymark, "generate", "map", "--kind", name, "--noise", noise, "--landmarks", "3", "--tasks",
                   "--width", str(options.side | 1), "--height", str(options.side | 1), "--seed", str(options.seed)]
    return subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout


def strategies(file):
    """The first lines and their decisions."""
    out = []
    for line in map(json.loads, filter(str.strip, file.read_text().splitlines())):
        if "automaton" in line:
            out.append((line, []))
        else:
            out[-1][1].append(line)
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("waymark")
    parser.add_argument("--side", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    wrong = values = 0
    print("| family | task | pairs met | bounds | by the other solver | outside |\n|---|---|---:|---|---:|---:|")
    with tempfile.TemporaryDirectory() as folder:
        case, file = Path(folder) / "case.json", Path(folder) / "strategies"
        for kind in KINDS:
            case.write_bytes(case_of(options, kind))
            subprocess.run([options.waymark, "plan", "--case", case, "--strategy", file], check=True,
                           stdout=subprocess.PIPE)
            for head, decisions in strategies(file):
                grid = Grid(json.loads(case.read_text()))
                chain = Chain(grid, head, decisions)
                found = chain.value(grid.cost if head["query"] == "rmin" else None)
                lower, upper = float(head["lower"]), float(head["upper"])
                outside = max(lower - found, found - upper, 0.0) / max(1.0, upper)
                values += 1
                wrong += outside > TOLERANCE
                print(f"| {kind} | `{head['task']}` | {len(chain.number):,} | {lower:.9g} to {upper:.9g} "
                      f"| {found:.9g} | {outside:.0e} |", flush=True)
    print(f"{values} values, {wrong} outside of their bounds by more than the tolerance")
    return 1 if wrong or values < len(KINDS) else 0


if __name__ == "__main__":
    sys.exit(main())
