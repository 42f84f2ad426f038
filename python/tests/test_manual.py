"""The examples of docs/python.md and of the README run as they stand, one after the other."""
import contextlib
import io
import os
import re
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class Manual(unittest.TestCase):
    def run_examples_of(self, page):
        blocks = re.findall(r"^```python\n(.*?)^```", (ROOT / page).read_text(), re.M | re.S)
        self.assertTrue(blocks, page)
        names, before = {}, os.getcwd()
        with tempfile.TemporaryDirectory() as scratch, contextlib.redirect_stdout(io.StringIO()) as said:
            os.chdir(scratch)
            try:
                for block in blocks:
                    exec(compile(block, page, "exec"), names)  # examples of our own pages
            finally:
                os.chdir(before)
        return said.getvalue()

    def test_the_page_of_the_module(self):
        said = self.run_examples_of("docs/python.md")
        self.assertIn("go to the lamp, then go to the easel.", said)
        self.assertIn("open | F grant", said)
        self.assertIn("contradicts itself", said)

    def test_the_readme(self):
        self.assertIn("certified", self.run_examples_of("README.md"))


if __name__ == "__main__":
    unittest.main()
