"""PRISM as a referee of values: the open planning cases, each with its model (.nm) and its properties (.props).

Values agree within 2e-6, absolute for probabilities and relative for costs: PRISM stops value iteration by a relative
difference, which bounds no error.
"""
import json
import math
import re
from pathlib import Path

from processes import run

COLUMNS = ("set", "lines", "equal", "differ", "waymark s", "s", "waymark no answer", "no answer")
TOLERANCE = 2e-6


def values_of(text):
    """By name of the property, what PRISM prints as its result."""
    values = {}
    for part in text.split("Model checking: ")[1:]:
        name, result = re.match(r'"([^"]+)"', part), re.search(r"^Result: (\S+)", part, re.M)
        if name and result:
            values[name[1]] = float(result[1].replace("Infinity", "inf"))
    return values


def ours(text):
    """By task, the value that waymark prints; an infeasible cost is infinite."""
    values = {}
    for line in text.splitlines():
        task = json.loads(line)
        if "value" in task:
            values[task["task"]] = math.inf if task["value"] is None else float(task["value"])
        elif task.get("status") == "infeasible":
            values[task["task"]] = math.inf if task.get("query") == "rmin" else 0.0
    return values


def agree(left, right, cost):
    if math.isinf(left) or math.isinf(right):
        return left == right
    return abs(left - right) <= TOLERANCE * (max(1, abs(right)) if cost else 1)


def prism(folder, case, seconds, say):
    """A row of the table for the case `FILE.nm`, and how many values differ."""
    properties = case.with_suffix(".props")
    count = properties.read_text().count('": ')
    program = str(Path(folder) / "waymark")
    mine = run([program, "plan", "--case", str(case.with_suffix(".json")), "--json", "--limit-seconds", str(seconds)],
               2 * count * seconds)
    its = run(["prism", str(case), str(properties), "-epsilon", "1e-9", "-maxiters", "10000000"], count * seconds,
              most_bytes=0)
    left, right = ours(mine.output), values_of(its.output)
    row = {"set": case.stem, "lines": count, "equal": 0, "differ": 0, "waymark s": mine.seconds, "s": its.seconds,
           "waymark no answer": len(set(right) - set(left)), "no answer": count - len(right)}
    for task in sorted(set(left) & set(right)):
        equal = agree(left[task], right[task], task.endswith("_rmin"))
        row["equal" if equal else "differ"] += 1
        if not equal:
            say(f"prism: {case.stem}/{task}: waymark has {left[task]!r}, PRISM {right[task]!r}")
    return row, row["differ"]
