"""The mutants that survive for a reason: survivors.md lists them below headings that say why.

An item is `- FILE:LINE:COLUMN KIND: CODE (MARK)`, the code in backticks, cut off by … where it is long. The mark is
made of the text of the line, and says which of equal lines it is and where in the line the mutant stands: an item
speaks of its mutant as long as the line is what it was, wherever that moves to.
"""
import hashlib
import re

ITEM = re.compile(r"- (\S+?):\d+:\d+ ([^\s:]+): `(.*)` \(([0-9a-f]{6})\)$")
MOST_SHOWN = 52  # characters of code


def shown(text):
    text = " ".join(text.split())
    return text if len(text) <= MOST_SHOWN else text[:MOST_SHOWN] + "…"


def mark(root, mutant):
    lines = (root / mutant.file).read_text().splitlines()
    line = lines[mutant.line - 1]
    same = sum(other.strip() == line.strip() for other in lines[:mutant.line - 1])
    column = mutant.column - (len(line) - len(line.lstrip()))
    return hashlib.sha256(repr((line.strip(), same, column)).encode()).hexdigest()[:6]


def read(path):
    """The headings by file, kind, code and mark."""
    heading, reasons = "", {}
    for line in path.read_text().splitlines() if path.exists() else ():
        if line.startswith("#"):
            heading = line.lstrip("# ")
        elif match := ITEM.fullmatch(line):
            reasons[match.groups()] = heading
    return reasons


def reason_of(reasons, root, mutant):
    return reasons.get((mutant.file, mutant.kind, shown(mutant.before), mark(root, mutant)))


def item(root, mutant):
    place = f"{mutant.file}:{mutant.line}:{mutant.column}"
    return f"- {place} {mutant.kind}: `{shown(mutant.before)}` ({mark(root, mutant)})"
