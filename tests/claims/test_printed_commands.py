"""Which words of a page are commands, and what is wrong with one."""
import sys
import unittest

sys.dont_write_bytecode = True
from printed_commands import Program, check

HELP = {
    (): "  walk              go somewhere\n  experiment        a table\n",
    ("walk",): "Usage: waymark walk [OPTIONS]\n\n  -F, --file FILE   where to\n  --fast, --no-fast  at speed\n  --seed N  of it\n",
    ("experiment",): "Usage: waymark experiment SUBCOMMAND [OPTIONS]\n\n  steps             how many\n",
    ("experiment", "steps"): "Usage: waymark experiment steps [OPTIONS]\n\n  --check                     again\n",
}


class PrintedCommands(unittest.TestCase):
    def faults(self, text):
        return check("# Title\n\n" + text, Program(lambda words: HELP[tuple(words)]))

    def test_right_commands_are_counted(self):
        self.assertEqual(self.faults("`waymark walk -F x --no-fast --seed=1`\n\n    waymark experiment steps \\\n"
                                     "        --check\n"), (2, []))

    def test_wrong_names_are_found_wherever_a_command_stands(self):
        for text in ("`waymark run`", "`waymark walk --sed 1`", "`waymark experiment stairs`", "`waymark experiment`",
                     "    waymark walk --fast \\\n        --check", "`waymark\nwalk --check`", "`walk --check`",
                     "`waymark walk --seed --fast`", "| | |\n|---|---|\n| command | `waymark walk --seed 1` |\n"
                     "| | `--check` |\n"):
            self.assertEqual(len(self.faults(text + "\n")[1]), 1, text)

    def test_options_of_a_table_belong_to_the_command_above_them(self):
        table = "| | |\n|---|---|\n| a | `waymark walk` |\n| | `--seed 1` |\n| b | the same with `{}` |\n"
        self.assertEqual(self.faults(table.format("--fast"))[1], [])
        self.assertEqual(len(self.faults(table.format("--check"))[1]), 1)

    def test_options_in_prose_belong_to_some_command_of_the_page(self):
        self.assertEqual(self.faults("With `--fast`.\n\n`waymark walk`\n")[1], [])
        self.assertEqual(len(self.faults("With `--check`.\n\n`waymark walk`\n")[1]), 1)


if __name__ == "__main__":
    unittest.main()
