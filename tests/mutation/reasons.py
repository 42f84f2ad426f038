"""The mutants that survive for a reason: survivors.md lists them below headings that say why.

An item is `- FILE:LINE:COLUMN KIND: CODE`, the code in backticks, cut off by … where it is long. It speaks of the
mutant of this kind at this place. Where a source has changed, its items are to be looked at anew.
"""
import re

ITEM = re.compile(r"- (\S+?):(\d+):(\d+) ([^\s:]+): `(.*)`$")
MOST_SHOWN = 52  # characters of code


def shown(text):
    text = " ".join(text.split())
    return text if len(text) <= MOST_SHOWN else text[:MOST_SHOWN] + "…"


def read(path):
    """The headings by file, line, column, kind and code."""
    heading, reasons = "", {}
    for line in path.read_text().splitlines() if path.exists() else ():
        if line.startswith("#"):
            heading = line.lstrip("# ")
        elif match := ITEM.fullmatch(line):
            reasons[match.groups()] = heading
    return reasons


def reason_of(reasons, mutant):
    return reasons.get((mutant.file, str(mutant.line), str(mutant.column), mutant.kind, shown(mutant.before)))


def item(mutant):
    return f"- {mutant.file}:{mutant.line}:{mutant.column} {mutant.kind}: `{shown(mutant.before)}`"
