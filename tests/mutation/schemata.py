"""One copy of a source that holds all of its mutants: `(mutant(7) ? (changed) : (kept))`, where kept holds more of them."""
import re

from finding import errors, parse

HEADER = b'#include "tests/mutation/mutant.hpp"\n'
MOST_ROUNDS = 12


class Schema:
    """Mutants of one source, numbered from `first`; some are dropped where the compiler objects."""

    def __init__(self, source, mutants, first):
        self.source, self.mutants = source, {first + i: mutant for i, mutant in enumerate(mutants)}

    def write(self):
        """The text, and where in it each mutant stands."""
        order = sorted(self.mutants.items(), key=lambda pair: (pair[1].start, -pair[1].end, pair[0]))
        self.out, self.ranges, self.order, self.next = bytearray(HEADER), {}, order, 0
        self.copy(0, len(self.source))
        return bytes(self.out)

    def copy(self, start, end):
        """Copies a range; mutants inside are written in the order of their beginnings, the outer ones first."""
        at = start
        while self.next < len(self.order) and self.order[self.next][1].start < end:
            number, mutant = self.order[self.next]
            self.next += 1
            self.out += self.source[at:mutant.start]
            begin = len(self.out)
            ask = "mutant_of_constexpr" if mutant.is_constexpr else "mutant"
            self.out += f"(::waymark_mutation::{ask}({number}U) ? ({mutant.after}) : (".encode()
            if mutant.kept is None:
                self.copy(mutant.start, mutant.end)
            else:
                self.out += mutant.kept.encode()
            self.out += b"))"
            self.ranges[number] = (begin, len(self.out))
            at = mutant.end
        self.out += self.source[at:end]

    def drop(self, offset):
        """Drops the innermost mutant around a byte of the text, else those of its line, else those nearby."""
        around = [(last - begin, number) for number, (begin, last) in self.ranges.items() if begin <= offset < last]
        dropped = [min(around)[1]] if around else []
        for lines in (0, 1, 4, 16):
            if dropped:
                break
            begin, last = self.lines_around(offset, lines)
            dropped = [number for number, (b, e) in self.ranges.items() if b < last and e > begin]
        for number in dropped:
            self.mutants.pop(number, None)
        return dropped

    def lines_around(self, offset, lines):
        begin = last = offset
        for _ in range(lines + 1):
            begin = max(0, self.out.rfind(b"\n", 0, max(0, begin - 1)))
            found = self.out.find(b"\n", last + 1)
            last = len(self.out) if found < 0 else found
        return begin, last

    def offset(self, line, column):
        at = 0
        for _ in range(line - 1):
            at = self.out.find(b"\n", at) + 1
        return at + column - 1


def check(schema, path, arguments):
    """Drops mutants until libclang takes the text, and returns the text."""
    for _ in range(MOST_ROUNDS):
        text = schema.write()
        wrong = [offset for offset, _ in errors(parse(path, arguments, text.decode())) if offset is not None]
        if not wrong:
            return text
        for offset in wrong:
            schema.drop(offset)
    schema.mutants.clear()
    return schema.write()


COMPLAINT = re.compile(r"^(\S[^:\n]*):(\d+):(\d+):\s+(error|.*required from)", re.M)


def complaints(log):
    """Places that a compiler calls wrong, those of errors first: file, line, column."""
    found = COMPLAINT.findall(log)
    return [(file, int(line), int(column), what == "error") for file, line, column, what in found]
