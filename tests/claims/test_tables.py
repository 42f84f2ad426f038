"""Which tables are results tables, and what counts as their provenance."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
from check_numbers import Provenance, verdict
from tables import blocks, is_results_table

TABLE = "| set | states | s |\n|---|---|---|\n| dwyer | 100 | 0.02 |\n| lily | 139 | 0.03 |\n"


def page(text):
    return blocks("# Title\n\n## Section\n\n" + text)


class Tables(unittest.TestCase):
    def kinds(self, text):
        return [is_results_table(block) for block in page(text)]

    def test_decimals_units_and_measured_titles_make_a_results_table(self):
        self.assertEqual(self.kinds(TABLE), [True])
        self.assertEqual(self.kinds("| x | y |\n|---|---|\n| a | 3 ms |\n"), [True])
        self.assertEqual(self.kinds("| x | states |\n|---|---|\n| a | 1,024 |\n"), [True])

    def test_counts_options_and_code_do_not(self):
        self.assertEqual(self.kinds("| status | meaning |\n|---|---|\n| 10 | the answer is no |\n"), [False])
        self.assertEqual(self.kinds("| option | what |\n|---|---|\n| a | `--discount 0.99` |\n"), [False])
        self.assertEqual(self.kinds("```\n" + TABLE + "```\n"), [])

    def test_a_row_with_an_empty_first_cell_continues_the_row_above(self):
        block, = page("| a | b |\n|---|---|\n| one | `x` |\n| | `y` |\n")
        self.assertEqual(block.rows()[1], ["one", "`x` `y`"])


class Origins(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.source = Path(self.folder.name)
        (self.source / "dev").touch()

    def tearDown(self):
        self.folder.cleanup()

    def kind(self, text, name="docs/page.md"):
        found = page(text)
        table = next(block for block in found if is_results_table(block))
        return verdict(name, table, found, self.source)[0]

    def test_a_paragraph_that_says_all_three_is_enough(self):
        self.assertEqual(self.kind(TABLE + "\nCommand: `./dev bench tables`; no seed; commit 24729e3.\n"), "ok")
        self.assertEqual(self.kind("The command is `waymark random`, seed 1, at commit 24729e3.\n\n" + TABLE), "ok")

    def test_a_table_of_properties_is_enough(self):
        self.assertEqual(self.kind(TABLE + "\n| | |\n|---|---|\n| command | `waymark evaluate` |\n"
                                           "| seed, commit | 1, 24729e3 |\n"), "ok")

    def test_each_of_the_three_is_missed(self):
        for missing in ("`waymark random`; seed 1", "seed 1; commit 24729e3", "`waymark random`; commit 24729e3",
                        "`unknown random`; seed 1; commit 24729e3"):
            self.assertEqual(self.kind(TABLE + f"\nCommand: {missing}.\n"), "fails")

    def test_another_section_does_not_count_and_an_enclosing_one_does(self):
        origin = "Command: `waymark random`; seed 1; commit 24729e3.\n\n"
        self.assertEqual(self.kind(origin + "## Other\n\n" + TABLE), "fails")
        self.assertEqual(self.kind(origin + "### Inner\n\n" + TABLE), "ok")

    def test_what_is_not_reproducible_says_why(self):
        self.assertEqual(self.kind(TABLE + "\nNot reproducible: the driver was not kept.\n"), "recorded")
        self.assertEqual(self.kind(TABLE + "\nNot reproducible:\n"), "fails")
        self.assertEqual(self.kind(TABLE + "\nRecorded at commit 24729e3.\n"), "fails")
        self.assertEqual(self.kind(TABLE + "\nRecorded at commit 24729e3.\n", "docs/notebook/page.md"), "recorded")

    def test_all_commits_are_found(self):
        block, = page("Seeds 1 and 20261125, `waymark random --seed 1234567`, commits 24729e3 and 9bc0ebf.\n")
        self.assertEqual(Provenance(block, self.source).commits, ["24729e3", "9bc0ebf"])


if __name__ == "__main__":
    unittest.main()
