#!/usr/bin/env python3
"""run.py SCRATCH [--mutants 2100] [--seed 1] [--unlike SEED:N...] [--after SEED:N...] [--area FOLDER...]
[--seconds-a-mutant 8]: mutation tests.

Operators, constants and conditions of the sources are changed one at a time, and the unit tests have to notice. SCRATCH
holds a copy of the tree in which every mutated expression asks whether its mutant is the active one, a build of the
copy, and results.tsv, to which each result is appended: a run that was interrupted goes on where it was.

A mutant is killed when a test that reaches it fails, crashes, or takes longer than five times its processor time and
two seconds. Mutants survive when all tests pass that reach them, together at most --seconds-a-mutant without a mutant.
survivors.md says of some why they do; the others are printed.
Exit code 0, whatever survives; 1 when tests fail without a mutant; 77 when libclang is missing.
"""
import argparse
import collections
import concurrent.futures
import hashlib
import os
import sys
import time
from pathlib import Path

sys.dont_write_bytecode = True
import finding
import reasons
import running
import subjects

VERDICTS = ("killed", "survived", "not reached")
COLUMNS = ("source", "file", "line", "column", "kind", "before", "after", "verdict", "by", "seconds")


def flat(text):
    return " ".join(text.split())


class Results:
    """The lines of results.tsv: one a mutant, found again by its place and its file's content."""

    def __init__(self, path, root):
        self.path, self.root, self.digests, self.known = path, root, {}, {}
        if path.exists():
            for line in path.read_text().splitlines()[1:]:
                cells = line.split("\t")
                if len(cells) == len(COLUMNS):
                    self.known[tuple(cells[:7])] = dict(zip(COLUMNS, cells))
        else:
            path.write_text("\t".join(COLUMNS) + "\n")

    def key(self, mutant):
        if mutant.file not in self.digests:
            self.digests[mutant.file] = hashlib.sha256((self.root / mutant.file).read_bytes()).hexdigest()[:12]
        return (self.digests[mutant.file], mutant.file, str(mutant.line), str(mutant.column), mutant.kind,
                flat(mutant.before), flat(mutant.after))

    def keep(self, mutant, verdict, by, seconds):
        cells = (*self.key(mutant), verdict, flat(by), f"{seconds:.3f}")
        self.known[cells[:7]] = dict(zip(COLUMNS, cells))
        with self.path.open("a") as file:
            file.write("\t".join(cells) + "\n")


def sample(mutants, wanted, seed):
    """At most so many, the same share of every area unless an area has fewer. Which are drawn depends on their code,
    not on their places: a change elsewhere leaves the others in the sample."""
    areas, seen = collections.defaultdict(list), collections.Counter()
    for number, (area, mutant) in sorted(mutants.items()):
        code = (mutant.file, mutant.kind, flat(mutant.before), flat(mutant.after))
        seen[code] += 1
        areas[area].append((hashlib.sha256(repr((seed, *code, seen[code])).encode()).digest(), number))
    chosen = []
    for left, (_, ranked) in zip(range(len(areas), 0, -1), sorted(areas.items(), key=lambda pair: len(pair[1]))):
        share = min(len(ranked), max(0, wanted - len(chosen)) // left)
        chosen += sorted(ranked)[:share]
    return [number for _, number in sorted(chosen)]


def drawn(mutants, options):
    """The sample, of the mutants that no draw of `--unlike SEED:N` has, nor those of `--after SEED:N` among these."""
    draws = [tuple(map(int, draw.split(":"))) for draw in options.unlike]
    others = {number for seed, many in draws for number in sample(mutants, many, seed)}
    left = {number: mutant for number, mutant in mutants.items() if number not in others}
    for draw in options.after:
        seed, many = map(int, draw.split(":"))
        earlier = set(sample(left, many, seed))
        left = {number: mutant for number, mutant in left.items() if number not in earlier}
    return sample(left, options.mutants, options.seed)


def counted(subject, chosen, results, explained):
    """By area: how many mutants have which verdict, how many survivors a reason, and minutes."""
    rows = collections.defaultdict(collections.Counter)
    for number in chosen:
        area, mutant = subject.mutants[number]
        if result := results.known.get(results.key(mutant)):
            rows[area][result["verdict"]] += 1
            rows[area]["minutes"] += float(result["seconds"]) / 60
            if result["verdict"] != "killed" and reasons.reason_of(explained, results.root, mutant):
                rows[area]["explained"] += 1
    rows["all"] = sum(rows.values(), collections.Counter())
    return rows


def table(rows):
    lines = ["| folder | mutants | killed | survived | not reached | explained | % killed | % of the unexplained | "
             "CPU minutes |", "|" + "---|" * 9]
    for area, row in rows.items():
        total = max(1, sum(row[verdict] for verdict in VERDICTS))
        others = max(1, total - row["explained"])
        lines.append(f"| `{area}` | {total} | {row['killed']} | {row['survived']} | {row['not reached']} | "
                     f"{row['explained']} | {100 * row['killed'] / total:.1f} | {100 * row['killed'] / others:.1f} | "
                     f"{row['minutes']:.1f} |")
    return "\n".join(lines)


def survivors(subject, chosen, results, explained):
    """The lines of those that survive without a reason."""
    for number in sorted(chosen):
        mutant = subject.mutants[number][1]
        result = results.known.get(results.key(mutant))
        if result and result["verdict"] != "killed" and not reasons.reason_of(explained, results.root, mutant):
            yield f"{reasons.item(results.root, mutant)}  =>  {flat(mutant.after)}  ({result['verdict']})"


def hunt(subject, options, results, explained):
    """Watches the tests, runs the mutants that have no result yet. False when tests fail without a mutant."""
    programs = {name: subject.program(name) for name in subject.programs()}
    tests, failing = running.watch_all(programs, list(subject.mutants), options.jobs, subject.scratch / "watched.json")
    for text in failing:
        print(text)
    if failing and not options.go_on:
        return None
    hunter = running.Hunt(programs, tests, options.seconds_a_mutant, options.longest_test)
    print(f"{len(tests)} tests, {sum(test.seconds for test in tests):.0f} s; too long to be run: "
          f"{', '.join(f'{t.program}: {t.name} ({t.seconds:.0f} s)' for t in hunter.too_long) or 'none'}", flush=True)
    chosen = drawn(subject.mutants, options)
    again = set(options.again.split(",")) if options.again else set()
    waiting = []
    for number in chosen:
        mutant = subject.mutants[number][1]
        known = results.known.get(results.key(mutant))
        left = known and known["verdict"] != "killed" and not reasons.reason_of(explained, results.root, mutant)
        if not known or known["verdict"] in again or (left and "left" in again):
            waiting.append(number)
    print(f"{len(subject.mutants)} mutants, {len(chosen)} of them chosen, {len(waiting)} to be run", flush=True)
    started = time.monotonic()

    def one(number):
        mutant = subject.mutants[number][1]
        results.keep(mutant, *hunter.one(mutant.file, number))

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for done, _ in enumerate(pool.map(one, waiting), 1):
            if done % 100 == 0:
                print(f"{done} of {len(waiting)}, {time.monotonic() - started:.0f} s", flush=True)
    return chosen


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scratch", type=Path, metavar="SCRATCH")
    options.add_argument("--mutants", type=int, default=2100, metavar="N", help="at most so many are run [2100]")
    options.add_argument("--seed", type=int, default=1, metavar="S", help="of which are run [1]")
    options.add_argument("--unlike", nargs="+", default=[], metavar="SEED:N",
                         help="none of those that these draws of N mutants have")
    options.add_argument("--after", nargs="+", default=[], metavar="SEED:N",
                         help="nor those of these draws, which had the same --unlike and --after those before")
    options.add_argument("--area", nargs="+", default=list(subjects.AREAS), choices=subjects.AREAS, metavar="FOLDER")
    options.add_argument("--seconds-a-mutant", type=float, default=8, metavar="T", help="of tests [8]")
    options.add_argument("--longest-test", type=float, default=10, metavar="T", help="longer tests are not run [10]")
    options.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N", help="side by side")
    options.add_argument("--again", default="", metavar="VERDICTS",
                         help="run these again: killed, survived, 'not reached', or left, which have no reason")
    options.add_argument("--go-on", action="store_true", help="although tests fail without a mutant, leaving them out")
    options.add_argument("--toy", action="store_true", help="mutate tests/mutation/toy alone")
    options = options.parse_args()
    if not finding.available:
        print("skipped: the Python bindings of libclang are missing (Debian: python3-clang-14)")
        return 77
    scratch = options.scratch.resolve()
    scratch.mkdir(parents=True, exist_ok=True)
    kind = subjects.Toy if options.toy else subjects.Subject
    areas = ["tests/mutation/toy"] if options.toy else options.area
    subject = kind(subjects.ROOT, scratch, areas)
    subject.prepare()
    for reason in subject.skipped:
        print(f"not mutated: {reason}")
    results = Results(scratch / "results.tsv", subjects.ROOT)
    explained = reasons.read(Path(__file__).with_name("survivors.md"))
    chosen = hunt(subject, options, results, explained)
    if chosen is None:
        return 1
    print(*survivors(subject, chosen, results, explained), sep="\n")
    print(table(counted(subject, chosen, results, explained)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
