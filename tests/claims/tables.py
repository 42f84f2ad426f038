"""Tables and paragraphs of Markdown pages, each with the section that it stands in."""
import re

FENCE = re.compile(r"^\s*(```|~~~)")
HEADING = re.compile(r"^(#+)\s+(.*)")
DELIMITER = re.compile(r"^\|[\s:|-]+\|$")
UNIT = r"(%|‰|×|ns|µs|ms|s|min|h|[KMG]i?B|bytes)(?!\w)"
MEASURED = re.compile(rf"(?<![\w.])\d[\d,]*(\.\d+|(\.\d+)?\s?{UNIT})")
NUMBER = re.compile(r"[−-]?\d[\d,]*(\.\d+)?")
MEASURES = re.compile(r"\b(s|ms|µs|ns|seconds?|states|edges|inputs|pairs met|bytes|memory|rate|ratio|before|after"
                      r"|[kMG]i?B|per cent)\b")


class Block:
    """A paragraph or a table: its text, the line where it begins, and the headings above it, the page's title first."""

    def __init__(self, lines, number, headings):
        self.lines, self.number, self.headings = lines, number, tuple(headings)
        self.text = " ".join(line.strip() for line in lines)
        self.is_table = len(lines) > 1 and bool(DELIMITER.match(lines[1].strip()))

    def rows(self):
        """Cells of the rows without the delimiter. A row with an empty first cell continues the one above."""
        rows = []
        for line in self.lines[:1] + self.lines[2:]:
            cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line.strip().strip("|"))]
            if len(rows) > 1 and not cells[0] and len(cells) == len(rows[-1]):
                rows[-1] = [f"{above} {cell}".strip() for above, cell in zip(rows[-1], cells)]
            else:
                rows.append(cells)
        return rows


def blocks(text):
    """Paragraphs and tables in order; blocks of code are left out."""
    found, current, headings, fenced = [], [], [], False

    def close(number):
        if current:
            found.append(Block(current[:], number - len(current), [title for _, title in headings]))
            current.clear()

    lines = text.splitlines()
    for number, line in enumerate(lines + [""], 1):
        heading = HEADING.match(line)
        if FENCE.match(line):
            close(number)
            fenced = not fenced
        elif fenced:
            continue
        elif heading:
            close(number)
            while headings and headings[-1][0] >= len(heading[1]):
                headings.pop()
            headings.append((len(heading[1]), heading[2]))
        elif not line.strip():
            close(number)
        else:
            current.append(line)
    return found


def measured_column(title, cells):
    """Half of the cells hold a decimal, a percentage or a unit; or are numbers, one of them such or so titled."""
    cells = [re.sub(r"`[^`]*`|\]\([^)]*\)|\*\*", " ", cell) for cell in cells if cell and cell != "–"]
    if not cells:
        return False
    measured = sum(bool(MEASURED.search(cell)) for cell in cells)
    numbers = sum(bool(NUMBER.match(cell)) for cell in cells) if measured or MEASURES.search(title) else 0
    return 2 * max(measured, numbers) >= len(cells)


def is_results_table(block):
    if not block.is_table:
        return False
    head, *rows = block.rows()
    return any(measured_column(title, [row[i] for row in rows if i < len(row)])
               for i, title in enumerate(head) if i)
