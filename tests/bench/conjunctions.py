#!/usr/bin/env python3
"""How many conjuncts of each specification pattern are monitored, and what one automaton of them would have.

usage: conjunctions.py WAYMARK [--before OTHER] [--seconds 4] [--memory 4]

For each pattern of Dwyer, Avrunin and Corbett, n conjuncts with propositions of their own: the time and the memory to
the first verdict over infinite words, for n = 2, 5, 10, 20, 30, and the states of the minimal DFA of n = 2 and 5. A
second program (an older build) is asked the same; of it, the largest n that it answers is printed. Prints a table in
Markdown.
"""
import argparse
import re
import resource
import subprocess
import tempfile
import time

SIZES = [2, 5, 10, 20, 30]


def patterns(waymark):
    out = subprocess.run([waymark, "patterns"], capture_output=True, text=True, check=True).stdout
    rows = [line.split("\t") for line in out.splitlines()]
    return [(row[0], row[1].split(), row[3]) for row in rows if row[4:] == ["DAC98"]]


def conjunction(letters, formula, n):
    def own(i):
        return re.sub(r"\b(" + "|".join(letters) + r")\b", lambda m: f"{m[1]}{i}", formula)
    return " & ".join(f"({own(i)})" for i in range(n))


def run(command, seconds, memory, text=""):
    """Seconds, MiB and the output; None when the limit is met."""
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (memory << 30, memory << 30))
    began = time.monotonic()
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                               text=True, preexec_fn=limit)
    try:
        out, _ = process.communicate(text, timeout=seconds)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        return None
    spent = time.monotonic() - began
    if process.returncode not in (0, 10):
        return None
    return spent, max(before, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss) >> 10, out


def largest(program, letters, formula, arguments):
    """The largest n that is answered, and its seconds."""
    best = (0, 0.0)
    for n in SIZES:
        with tempfile.NamedTemporaryFile("w", suffix=".ltl") as file:
            file.write(conjunction(letters, formula, n) + "\n")
            file.flush()
            answer = run([program, "monitor", "-F", file.name, "--quiet"], arguments.seconds, arguments.memory, "{}\n")
        if answer is None:
            break
        best = (n, answer[0])
    return best


def states(program, letters, formula, n, arguments):
    answer = run([program, "translate", conjunction(letters, formula, n), "--to", "dfa", "--format", "stats"],
                 arguments.seconds, arguments.memory)
    rows = [line.split("\t") for line in answer[2].splitlines()] if answer else []
    return rows[-1][1] if rows and rows[-1][6] == "ok" else "–"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("waymark")
    parser.add_argument("--before")
    parser.add_argument("--seconds", type=float, default=4, help="limit of one question")
    parser.add_argument("--memory", type=int, default=4, help="limit in GiB")
    arguments = parser.parse_args()
    print("| pattern | DFA, n = 2 | n = 5 | one monitor: n | s | apart: n | s |")
    print("| --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    for name, letters, formula in patterns(arguments.waymark):
        sizes = [states(arguments.waymark, letters, formula, n, arguments) for n in (2, 5)]
        before = largest(arguments.before, letters, formula, arguments) if arguments.before else (0, 0.0)
        after = largest(arguments.waymark, letters, formula, arguments)
        print(f"| {name} | {sizes[0]} | {sizes[1]} | {before[0]} | {before[1]:.2f} | {after[0]} | {after[1]:.2f} |",
              flush=True)


if __name__ == "__main__":
    main()
