#!/usr/bin/env python3
"""run.py DIRECTORY_OF_PROGRAMS [--seconds-a-line 8] [--random 200] [--seed 1] [--lines N] [PEER...]

Other tools as referees of waymark: over the open corpora ($WAYMARK_SHARED, else ../shared beside the source tree) and
random formulas, one table for each tool with sizes, seconds and verdicts. Seconds are processor seconds in user mode of
whole processes, where ltlcross and autcross do not measure themselves. --lines: at most so many of each set.
Exit code 1: an answer differs. Exit code 77: none of the tools is installed, or nothing is there to compare.
"""
import argparse
import os
import shutil
import sys
from pathlib import Path

sys.dont_write_bytecode = True
import finite
import formulas
import omega
import planning

ROOT = Path(__file__).resolve().parents[2]
PEERS = (*omega.PEERS, *finite.PEERS, "prism")


def shared():
    return Path(os.environ.get("WAYMARK_SHARED", ROOT.parent / "shared"))


def sets_of(pattern, arguments, is_finite):
    """The sets of formulas, each a name and its lines with their numbers; random formulas are the first."""
    if arguments.random:
        yield f"random, seed {arguments.seed}", list(enumerate(
            formulas.random_formulas(arguments.random, arguments.seed, is_finite), 1))
    for file in sorted((shared() / "ltl").glob(pattern)):
        lines = [(number, line) for number, line in enumerate(file.read_text().splitlines(), 1) if line.strip()]
        if lines[:arguments.lines]:
            yield file.stem, lines[:arguments.lines]


def cell(value):
    return f"{value:.2f}" if isinstance(value, float) else str(value)


def print_row(cells):
    print("| " + " | ".join(map(cell, cells)) + " |", flush=True)


def rows_of(peer, arguments, say):
    """Rows of the table of a peer, each with the number of its differences."""
    seconds, folder = arguments.seconds_a_line, arguments.programs
    if peer in finite.PEERS:
        translate = finite.waymark(folder)
        for name, lines in sets_of("ltlf_*.ltlf", arguments, True):
            yield finite.row(name, translate, peer, lines, seconds, say)
    elif peer in omega.PEERS:
        for name, lines in sets_of("ltl_*.ltl", arguments, False):
            rows, differences = omega.PEERS[peer](folder, name, lines, seconds, say)
            yield from ((row, 0) for row in rows)
            yield None, differences
    else:
        for case in sorted((shared() / "plan/cases").glob("*.nm"))[:arguments.lines]:
            yield planning.prism(folder, case, seconds, say)


def table(peer, arguments):
    """Prints the table of a peer; gives the number of its rows and of its differences."""
    columns = {**dict.fromkeys(finite.PEERS, finite.COLUMNS), **dict.fromkeys(omega.PEERS, omega.COLUMNS)}
    columns = columns.get(peer, planning.COLUMNS)
    found, count, total = [], 0, dict.fromkeys(columns, 0)
    print(f"\n{peer}, {arguments.seconds_a_line:g} s a line:\n")
    print_row(columns)
    print_row("---" if name in ("set", "tool") else "---:" for name in columns)
    for row, differences in rows_of(peer, arguments, found.append):
        count += differences
        if row:
            print_row(row[name] for name in columns)
            total = {name: total[name] + row[name] if name not in ("set", "tool") else "all" for name in columns}
    if "tool" not in columns and total[columns[0]]:
        print_row(total[name] for name in columns)
    for line in found:
        print(f"DIFFERS: {line}")
    return bool(total[columns[0]]), count


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=Path)
    parser.add_argument("peers", nargs="*", metavar="PEER", help=", ".join(PEERS))
    parser.add_argument("--seconds-a-line", type=float, default=8)
    parser.add_argument("--random", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--lines", type=int)
    arguments = parser.parse_intermixed_args()
    for name in arguments.peers:
        if name not in PEERS:
            parser.error(f"{name} is no peer; there are {', '.join(PEERS)}")
    if not shared().is_dir():
        print(f"skipped: the open corpora are not at {shared()} (set WAYMARK_SHARED)")
    compared, missing, differences = 0, [], 0
    for peer in arguments.peers or PEERS:
        if not shutil.which(peer):
            print(f"skipped: {peer} is not installed")
            missing.append(peer)
            continue
        rows, differs = table(peer, arguments)
        compared += rows
        differences += differs
    print(f"\n{compared} peers compared, {differences} differences, {len(missing)} peers not installed")
    return 1 if differences else 0 if compared else 77


if __name__ == "__main__":
    sys.exit(main())
