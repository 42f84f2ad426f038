#!/usr/bin/env python3
"""How many conjuncts of each specification pattern are monitored, and what one automaton of them would have.

usage: conjunctions.py WAYMARK [--before OTHER] [--seconds 4] [--memory 4] [--stream]

For each pattern of Dwyer, Avrunin and Corbett, n conjuncts with propositions of their own: the largest n of 2, 5, 10,
20, 30 up to which the first verdict over infinite words comes within the limits, its seconds, and the states of the
minimal DFA of n = 2 and 5. A second program (an older build) is asked the same. Prints a table in Markdown.

With --stream instead: seconds of `monitor --quiet` on 200 responses and 200,000 letters of five random propositions
each (1,000 different ones, seed 1), with triggers of their own and with a common one, over infinite and finite words.
"""
import argparse
import random
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
    """Seconds and the output; None when a limit is met, or it fails."""
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (memory << 30, memory << 30))
    began = time.monotonic()
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
    return spent, out


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
    rows = [line.split("\t") for line in answer[1].splitlines()] if answer else []
    return rows[-1][1] if rows and rows[-1][6] == "ok" else "–"


def stream(arguments):
    print("| triggers | words | s |\n| --- | --- | ---: |")
    for triggers, name in (([f"a{i}" for i in range(200)], "own"), (["a"], "common")):
        goals = [f"b{i}" for i in range(200)]
        formula = " & ".join(f"G({triggers[i % len(triggers)]} -> F {goal})" for i, goal in enumerate(goals))
        draw = random.Random(1)
        letters = ["{" + ",".join(draw.sample(triggers + goals, 5)) + "}\n" for _ in range(1000)]
        text = "".join(draw.choice(letters) for _ in range(200_000))
        for words in ("infinite", "finite"):
            with tempfile.NamedTemporaryFile("w", suffix=".ltl") as file:
                file.write(formula + "\n")
                file.flush()
                answer = run([arguments.waymark, "monitor", "-F", file.name, "--quiet", "--semantics", words], 60,
                             arguments.memory, text)
            print(f"| {name} | {words} | {answer[0]:.2f} |" if answer else f"| {name} | {words} | – |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("waymark")
    parser.add_argument("--before")
    parser.add_argument("--seconds", type=float, default=4, help="limit of one question")
    parser.add_argument("--memory", type=int, default=4, help="limit in GiB")
    parser.add_argument("--stream", action="store_true", help="200 responses and 200,000 letters")
    arguments = parser.parse_args()
    if arguments.stream:
        stream(arguments)
        return
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
