#!/usr/bin/env python3
"""test_run.py: the mutation tests on a toy source, whose mutants are known: what is killed, what survives, what is not
reached. Exit code 77: libclang or GoogleTest is missing."""
import argparse
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
import finding
import reasons
import run

SCRIPT = Path(run.__file__)


def mutation_tests(scratch, *options):
    return subprocess.run([sys.executable, "-B", SCRIPT, scratch, "--toy", *options], stdout=subprocess.PIPE, text=True,
                          check=False)


def results(scratch):
    lines = [line.split("\t") for line in (Path(scratch) / "results.tsv").read_text().splitlines()[1:]]
    return [dict(zip(run.COLUMNS, cells)) for cells in lines]


class Toy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory(prefix="waymark-mutation-")
        cls.done = mutation_tests(cls.scratch.name)
        cls.results = results(cls.scratch.name)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def verdicts(self, before):
        return {(result["kind"], result["verdict"]) for result in self.results if result["before"] == before}

    def test_ends_well(self):
        self.assertEqual(self.done.returncode, 0, self.done.stdout)

    def test_finds_every_mutant_once(self):
        self.assertEqual(len(self.results), 10)

    def test_a_tested_comparison_is_killed(self):
        self.assertEqual(self.verdicts("low <= x"), {("<=", "killed")})
        self.assertEqual(self.verdicts("low <= x && x < high"), {("&&", "killed")})

    def test_an_untested_bound_survives(self):
        self.assertEqual(self.verdicts("x > 100"), {(">", "survived"), ("condition", "survived")})

    def test_what_nothing_calls_is_not_reached(self):
        self.assertEqual(self.verdicts("!given"), {("not", "not reached")})

    def test_a_run_goes_on_where_it_was(self):
        self.assertIn(" 0 to be run", mutation_tests(self.scratch.name).stdout)
        self.assertEqual(len(results(self.scratch.name)), 10)

    def test_a_reason_is_found_as_long_as_its_line_is_the_same(self):
        root = Path(self.scratch.name)
        path, source = root / "survivors.md", root / "some.cpp"
        mutant = finding.Mutant("some.cpp", 2, 7, "<", 0, 0, "x <\n  y", "x <= y", None, False)
        moved = mutant._replace(line=4, column=9)
        source.write_text("\n  if (x <\n  y)\n")
        path.write_text(f"# Why\n\n## Ties\n\nThey are equal.\n\n{reasons.item(root, mutant)}\n")
        explained = reasons.read(path)
        self.assertEqual(reasons.reason_of(explained, root, mutant), "Ties")
        self.assertIsNone(reasons.reason_of(explained, root, mutant._replace(kind="<=")))
        self.assertIsNone(reasons.reason_of(explained, root, mutant._replace(column=8)))
        source.write_text("\n\n\n    if (x <\n  y)\n")
        self.assertEqual(reasons.reason_of(explained, root, moved), "Ties")
        source.write_text("\nif (x <\n\n    if (x <\n  y)\n")
        self.assertIsNone(reasons.reason_of(explained, root, moved), "one of two equal lines")
        source.write_text("\n\n\n    if (z < 1 && x <\n  y)\n")
        self.assertIsNone(reasons.reason_of(explained, root, moved))

    def test_the_sample_is_that_of_the_seed(self):
        def mutant(line):
            return finding.Mutant("some.cpp", line, 1, "constant", 0, 0, str(line % 7), "8", None, False)
        mutants = {number: ("one" if number < 50 else "other", mutant(number)) for number in range(1, 200)}
        chosen = run.sample(mutants, 120, 1)
        self.assertEqual(chosen, run.sample(mutants, 120, 1))
        self.assertNotEqual(set(chosen), set(run.sample(mutants, 120, 2)))
        self.assertEqual(len(chosen), 120)
        self.assertEqual(sum(number < 50 for number in chosen), 49)  # no more than there are
        moved = {number + 10: (area, m._replace(line=m.line + 3)) for number, (area, m) in mutants.items()}
        self.assertEqual([number + 10 for number in chosen], run.sample(moved, 120, 1))

    def test_a_draw_leaves_out_what_others_drew(self):
        mutants = {number: ("one", finding.Mutant("some.cpp", number, 1, "constant", 0, 0, str(number), "8", None,
                                                  False)) for number in range(1, 200)}
        options = argparse.Namespace(unlike=["1:60", "2:50"], after=[], mutants=40, seed=3)
        earlier = set(run.sample(mutants, 60, 1)) | set(run.sample(mutants, 50, 2))
        chosen = run.drawn(mutants, options)
        self.assertEqual(len(chosen), 40)
        self.assertFalse(earlier & set(chosen))
        everything = run.drawn(mutants, argparse.Namespace(unlike=["1:60", "2:50"], after=["3:40"], mutants=500,
                                                              seed=4))
        earlier |= set(chosen)
        self.assertFalse(earlier & set(everything))
        self.assertEqual(set(everything) | earlier, set(mutants))


if __name__ == "__main__":
    if not finding.available:
        print("skipped: the Python bindings of libclang are missing (Debian: python3-clang-14)")
        sys.exit(77)
    unittest.main(verbosity=2)
