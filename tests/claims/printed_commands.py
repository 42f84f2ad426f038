#!/usr/bin/env python3
"""printed_commands.py WAYMARK PAGE: every `waymark ...` command that the page prints is one that parses.

A command stands in backticks or in an indented block, and may go on in the next row of its table or after a backslash.
Options in backticks without a command belong to the command above them in their table; outside tables they belong to
some command of the page. Subcommands, options and whether an option takes a value are looked up in what `waymark
SUBCOMMAND --help-all` prints; the values are not. Exit code 1: a command does not parse, or the page has none.
"""
import re
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
from tables import blocks

QUOTED = re.compile(r"`([^`]+)`")
IS_OPTION = re.compile(r"--?[A-Za-z]")
SUBCOMMAND = re.compile(r"^  ([a-z][\w-]*) {2,}", re.M)
OPTION = re.compile(r"^  (-\S+(?:, -\S+)*)(?: ([A-Z]\S*))?(?: {2,}|$)", re.M)  # "  -F, --file FILE   read …"


class Printed:
    """Words of a command, or of options alone, where they stand, and whether in a table."""

    def __init__(self, words, block):
        self.words, self.line, self.in_table = words, block.number, block.is_table


def printed(text):
    found = []
    for block in blocks(text):
        if block.lines[0].startswith("    "):
            code = re.sub(r"\\\n", " ", "\n".join(block.lines)).splitlines()
        elif block.is_table:
            code = [code for row in block.rows() for cell in row for code in QUOTED.findall(cell)]
        else:
            code = QUOTED.findall(block.text)
        found += [Printed(words, block) for words in map(str.split, code) if words]
    return found


class Program:
    """What the help of the program says; `say(words)` gives the help of a subcommand, or of the whole for no words."""

    def __init__(self, say):
        self.say, self.known = say, {}
        self.names = set(SUBCOMMAND.findall(say([])))

    def subcommand(self, words):
        """The leading words that name a subcommand; None: there is none of the name."""
        if not words or words[0] not in self.names:
            return None
        inner = set(SUBCOMMAND.findall(self.say(words[:1]))) if "SUBCOMMAND" in self.say(words[:1]) else None
        if inner is None:
            return words[:1]
        return words[:2] if len(words) > 1 and words[1] in inner else None

    def options(self, name):
        """Option → whether it takes a value."""
        key = tuple(name)
        if key not in self.known:
            self.known[key] = {option: bool(value) for options, value in OPTION.findall(self.say(name))
                               for option in options.split(", ")}
        return self.known[key]

    def wrong(self, name, words):
        """What is wrong with these options of the subcommand, or None."""
        options = self.options(name)
        for word, following in zip(words, words[1:] + [""]):
            option, has_value, _ = word.partition("=")
            if not IS_OPTION.match(word):
                continue
            if option not in options:
                return f"waymark {' '.join(name)} has no option {option}"
            if options[option] and not has_value and IS_OPTION.match(following):
                return f"waymark {' '.join(name)}: {option} takes a value"
        return None


def check(text, program):
    """How many commands there are, and the faults."""
    names, faults, loose, above = [], [], [], (None, None)
    for one in printed(text):
        words, fault = one.words, None
        if words[0] == "waymark" or (words[0] in program.names and len(words) > 1):
            rest = words[words[0] == "waymark":]
            name = program.subcommand(rest)
            if name is None:
                fault = f"no subcommand: {' '.join(rest[:2])}"
            else:
                fault = program.wrong(name, rest[len(name):])
                names.append(name)
                above = (one.line, name)
        elif IS_OPTION.match(words[0]):
            if one.in_table and above[0] == one.line:
                fault = program.wrong(above[1], words)
            else:
                loose.append(one)
        if fault:
            faults.append((one.line, fault))
    for one in loose:
        if all(program.wrong(name, one.words) for name in names):
            faults.append((one.line, f"no command of the page has the options {' '.join(one.words)}"))
    return len(names), sorted(faults)


def main(waymark, page):
    helps = {}

    def say(words):
        key = tuple(words)
        if key not in helps:
            run = subprocess.run([waymark, *words, "--help-all" if words else "--help"], stdout=subprocess.PIPE,
                                 text=True, check=True)
            helps[key] = run.stdout
        return helps[key]

    commands, faults = check(Path(page).read_text(), Program(say))
    for line, fault in faults:
        print(f"{page}:{line}: {fault}")
    print(f"{commands} commands, {len(faults)} faults")
    return 1 if faults or not commands else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
