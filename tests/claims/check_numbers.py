#!/usr/bin/env python3
"""check_numbers.py SOURCE [--list]: every results table of the documentation says where its numbers come from.

A results table has a column, other than the first, of measured numbers: decimals, percentages or units (tables.py).
A paragraph of its section, or of a section that encloses it, or a table of the section that begins with the row
`command`, must name all of

    a command in backticks, that begins with a program or script of the repository;
    `seed N`, or `no seed` where nothing is random;
    `commit C`, an ancestor of the commit that is checked out.

The form to write is: Command: `waymark …`; seed 1; commit 1234567. Where no command gives the numbers again, the
paragraph is `Not reproducible: REASON.`; in the notebook, whose drivers were not kept, `Recorded at commit C` says
so. Such tables are counted and printed. --list prints all tables. Exit code 1: a table fails.
"""
import re
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
from tables import blocks, is_results_table

# (page, heading above the table): why its numbers are not ours, or are no measurements
ALLOWED = {
    ("docs/results.md", "What have others published?"): "published by others",
    ("docs/notebook/learning.md", "Learners that were removed"): "descriptions; 0.98 is a setting of one of them",
}
WRAPPERS = {"/usr/bin/time", "perf", "stat", "nice", "python3"}
COMMIT = re.compile(r"\bcommits? ((?:[^.;]|\.\d)*)", re.I)
HASH = re.compile(r"\b(?=[0-9a-f]*\d)[0-9a-f]{7,12}\b")
NOT_REPRODUCIBLE = re.compile(r"\bNot reproducible: (\w[^|]{9,})")
RECORDED = re.compile(r"\bRecorded at commits? [0-9a-f]{7}")


def is_program(word, source):
    if word in ("waymark", "waymark-lab"):
        return True
    if word.startswith("bench_"):
        stem = word.removeprefix("bench_")
        return any((source / "tests/bench" / f"{name}.cpp").exists() for name in (stem, f"{stem}_bench"))
    if word.startswith("test_"):
        return (source / "tests" / word.removeprefix("test_") / "CMakeLists.txt").exists()
    return ("/" in word or word == "dev") and (source / word).exists() and not word.endswith((".md", ".cpp", ".hpp"))


def command_of(text, source):
    """The first command in backticks."""
    for code in re.findall(r"`([^`]+)`", text):
        words = [word for word in code.split() if word not in WRAPPERS and not re.match(r"-|\d|\w+=", word)]
        if words and is_program(words[0], source):
            return code
    return None


def is_provenance(block):
    """A paragraph, or a table of two columns without titles, with a row `command` or `commit`."""
    if not block.is_table:
        return True
    head, *rows = block.rows()
    return not any(head) and any(re.search(r"\bcommand|\bcommit\b", row[0]) for row in rows)


class Provenance:
    """What a paragraph, or a table of properties, says about where numbers come from."""

    def __init__(self, block, source):
        self.block = block
        rows = block.rows() if block.is_table else []
        text = block.text if not rows else ". ".join(" ".join(row) for row in rows)
        self.command = command_of(text, source)
        self.seed = bool(re.search(r"\bseeds?\b", text, re.I))
        parts = [row[1] for row in rows if re.search(r"\bcommit\b", row[0])] or COMMIT.findall(text)
        self.commits = [commit for part in parts for commit in HASH.findall(part)]
        reason = NOT_REPRODUCIBLE.search(text)
        self.reason = reason[1] if reason else "recorded, driver not kept" if RECORDED.search(text) else None

    def missing(self):
        return [name for name, there in (("command", self.command), ("seed", self.seed), ("commit", self.commits))
                if not there]


def in_scope(block, table, notebook):
    """In the section of the table, or in one around it; the introduction of a page counts in the notebook only."""
    depth = len(block.headings)
    if block is table or not is_provenance(block) or block.headings != table.headings[:depth]:
        return False
    return depth == len(table.headings) or depth > 1 or notebook


def verdict(page, table, page_blocks, source):
    """A kind (ok, recorded, allowed, fails) and what to say of it, with the commits that are named."""
    for heading in table.headings:
        if (page, heading) in ALLOWED:
            return "allowed", ALLOWED[page, heading], []
    notebook = page.startswith("docs/notebook/")
    said = [Provenance(block, source) for block in page_blocks if in_scope(block, table, notebook)]
    said.sort(key=lambda one: (len(one.missing()), abs(one.block.number - table.number)))
    if said and not said[0].missing():
        return "ok", said[0].command, said[0].commits
    for one in sorted(said, key=lambda one: abs(one.block.number - table.number)):
        if one.reason and (notebook or "Not reproducible" in one.block.text):
            return "recorded", one.reason, one.commits
    return "fails", "no paragraph of its section has " + " and ".join(said[0].missing() if said else ["anything"]), []


def history(source):
    """The commits up to the one checked out, or None where the history is not there."""
    def git(*arguments):
        return subprocess.run(["git", "-C", str(source), *arguments], stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, text=True, check=False)
    if git("rev-parse", "--is-shallow-repository").stdout.strip() != "false":
        return None
    return sorted(git("rev-list", "HEAD").stdout.split())


def main(source, *options):
    source = Path(source).resolve()
    known, counts, named = history(source), {}, {}
    for file in [*sorted((source / "docs").rglob("*.md")), source / "README.md"]:
        page = file.relative_to(source).as_posix()
        page_blocks = blocks(file.read_text())
        for table in filter(is_results_table, page_blocks):
            if is_provenance(table):
                continue
            kind, why, commits = verdict(page, table, page_blocks, source)
            counts[kind] = counts.get(kind, 0) + 1
            for commit in commits:
                named.setdefault(commit, f"{page}:{table.number}")
            if kind in ("fails", "recorded") or options:
                print(f"{kind}: {page}:{table.number}: {table.headings[-1]}: {why}")
    unknown = [] if known is None else [commit for commit in named if not any(c.startswith(commit) for c in known)]
    for commit in unknown:
        print(f"fails: {named[commit]}: commit {commit} is no ancestor of the one checked out")
    if known is None:
        print("the history is not there (no git, or a shallow clone): the commits were not looked up")
    print(f"{sum(counts.values())} results tables: {counts.get('ok', 0)} with command, seed and commit; "
          f"{counts.get('recorded', 0)} not reproducible, with a reason; {counts.get('allowed', 0)} not ours; "
          f"{counts.get('fails', 0)} fail; {len(named)} commits named")
    return 1 if counts.get("fails") or unknown else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
