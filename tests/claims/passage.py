#!/usr/bin/env python3
"""Write a planning case: two halves of free ground and a bridge between them, lava (x) on both sides of it.

  tests/claims/passage.py SIDE WIDTH NOISE > case.json

SIDE: cells; the bridge is a fifth of it long. WIDTH: cells of the bridge. NOISE: the chance to slip to each side and
backwards. Nothing is random.
"""
import json
import sys

LEGEND = {"#": {"wall": True}, "x": {"props": ["x"]}}
TASKS = [
    ("one", "ltl", "(!x) U a", "pmax"),
    ("four", "ltl", "(!x) U (a & ((!x) U (b & ((!x) U (c & ((!x) U d))))))", "pmax"),
    ("seq", "ltlf", "F (a & (F (b & (F (c & (F d))))))", "rmin"),
    ("least", "ltl", "F x", "pmin"),
]


def rows_of(side, width):
    first, top = (side - side // 5) // 2, side // 2
    bridge = range(first, first + side // 5)

    def cell(x, y):
        if x not in bridge or 0 <= y - top < width:
            return "."
        return "x" if y in (top - 1, top + width) else "#"

    rows = [[cell(x, y) for x in range(side)] for y in range(side)]
    for name, (x, y) in waypoints(side).items():
        rows[y][x] = name
    return ["".join(row) for row in rows]


def waypoints(side):
    return {"a": (side - 3, 2), "b": (2, side - 3), "c": (side - 4, side - 4), "d": (3, 3)}


def main():
    side, width, noise = int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3])
    json.dump({
        "format": "ltlgrid/1", "name": f"passage-{side}-{width}", "width": side, "height": side,
        "rows": rows_of(side, width), "legend": LEGEND | {name: {"props": [name]} for name in "abcd"},
        "start": {"x": 2, "y": side // 2}, "moves": ["N", "E", "S", "W"],
        "motion": {"forward": 1 - 3 * noise, "left": noise, "right": noise, "back": noise, "blocked": "stay"},
        "cost": {"step": 1},
        "tasks": [dict(zip(("id", "logic", "formula", "query"), task)) for task in TASKS],
    }, sys.stdout)


if __name__ == "__main__":
    main()
