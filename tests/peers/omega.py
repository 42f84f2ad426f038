"""Spot's ltlcross and autcross as referees of automata on infinite words: their verdicts and their tables.

ltlcross translates each formula and its negation by every translator, and autcross transforms each automaton by every
tool; both compare what comes out, and measure the seconds of wall-clock time of each process.
"""
import csv
import io
import re
import shlex
import tempfile
from pathlib import Path

from processes import run

TARGETS = ("tgba", "buchi", "parity", "ldba", "generic")
COLUMNS = ("set", "lines", "tool", "answers", "states", "edges", "s", "errors")


def translators(program, seconds):
    return [f"{{waymark {target}}}{program} translate --to {target} --threads 1 --limit-seconds {seconds} -F %F >%O"
            for target in TARGETS] + ["{Spot, deterministic parity}ltl2tgba --deterministic --parity -F %F >%O"]


def tools(program, seconds):
    return ([f"{{waymark {target}}}{program} automaton %H --to {target} --limit-seconds {seconds} >%O"
             for target in ("buchi", "parity", "generic")]
            + [f"{{waymark reduce}}{program} automaton %H --reduce --limit-seconds {seconds} >%O",
               "{Spot, deterministic parity}autfilt --deterministic --parity %H >%O"])


def table_of(text):
    """By tool: answers, states, edges and seconds in a table that ltlcross or autcross wrote with --csv."""
    rows = {}
    for line in csv.DictReader(io.StringIO(text)):
        row = rows.setdefault(line["tool"], {"answers": 0, "states": 0, "edges": 0, "s": 0.0})
        states, edges = (line.get(name) or line.get(f"output.{name}") for name in ("states", "edges"))
        row["s"] += float(line["time"] or 0)
        if line["exit_status"] == "ok" and states:
            row["answers"] += 1
            row["states"] += int(states)
            row["edges"] += int(edges)
    return rows


def failures_of(text):
    """Rows of processes that neither answered nor gave up, which waymark says by exit code 11."""
    return [f"{line['tool']}: {line['exit_status']} {line['exit_code']}" for line in csv.DictReader(io.StringIO(text))
            if line["exit_status"] not in ("ok", "timeout") and line["exit_code"] != "11"]


def errors_of(answer):
    """What the referee complains of; its exit status alone also counts."""
    complaints = re.findall(r"^error:.*", answer.errors + answer.output, re.M)
    last = (answer.errors.strip().splitlines() or ["no message"])[-1]
    return complaints or ([f"the referee ended with status {answer.status}: {last}"] if answer.status else [])


def cross(command, name, text, count, seconds, tool_count, say):
    with tempfile.TemporaryDirectory() as folder:
        table, lines = Path(folder) / "table.csv", Path(folder) / "lines"
        lines.write_text(text)
        answer = run([*command, "--ignore-execution-failures", f"--timeout={max(1, round(2 * seconds))}",
                      f"--csv={table}", f"--file={lines}"], (count + 1) * 3 * seconds * tool_count, most_bytes=0)
        written = table.read_text() if table.exists() else ""
    rows = table_of(written)
    errors = errors_of(answer) if answer.status is not None else ["the referee was cut off"]
    errors += failures_of(written)
    for error in errors:
        say(f"{command[0]}: {name}: {error}")
    return [{"set": name, "lines": count, "tool": tool, "errors": len(errors), **row} for tool, row in rows.items()], \
        len(errors)


def ltlcross(folder, name, lines, seconds, say):
    program = shlex.quote(str(Path(folder) / "waymark"))
    command = ["ltlcross", "--reference={Spot}ltl2tgba -F %F >%O", *translators(program, seconds)]
    return cross(command, name, "".join(f"{text}\n" for _, text in lines), len(lines), seconds, len(TARGETS) + 2, say)


def autcross(folder, name, lines, seconds, say):
    program = str(Path(folder) / "waymark")
    translated = run([program, "translate", "--one-line", "--threads", "1", "--limit-seconds", str(seconds), "-"],
                     len(lines) * seconds, "".join(f"{text}\n" for _, text in lines))
    command = ["autcross", "--language-preserved", *tools(shlex.quote(program), seconds)]
    return cross(command, name, translated.output, len(lines), seconds, 6, say)


PEERS = {"ltlcross": ltlcross, "autcross": autcross}
