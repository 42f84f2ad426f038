"""Peers that translate LTL over finite words: MONA, Lydia, Spot's ltlf2dfa. Language, states and seconds, by line.

For MONA a formula becomes one of first-order logic, φ at position x, as in De Giacomo and Vardi, IJCAI 2013.
"""
import json
import tempfile
from pathlib import Path

import formulas
import words
from processes import run

MOST_PROPOSITIONS = 8

def first_order(formula, x, fresh, names):
    """φ holds at position x, in M2L; names: MONA's variable of each proposition."""
    operator, *operands = formula

    def at(i, y):
        return first_order(operands[i], y, fresh, names)

    def new():
        fresh[0] += 1
        return f"v{fresh[0]}"

    if not operands:
        return {"0": "false", "1": "true"}.get(operator) or f"({x} in {names[operator]})"
    if operator == "!":
        return f"~({at(0, x)})"
    if operator in ("&", "|", "->", "<->"):
        sign = {"->": "=>", "<->": "<=>"}.get(operator, operator)
        return f"(({at(0, x)}) {sign} ({at(1, x)}))"
    y = new()
    if operator == "X[!]":
        return f"(ex1 {y}: {x} < {y} & {y} = {x} + 1 & ({at(0, y)}))"
    if operator == "X":
        return f"(all1 {y}: ({x} < {y} & {y} = {x} + 1) => ({at(0, y)}))"
    if operator == "F":
        return f"(ex1 {y}: {x} <= {y} & ({at(0, y)}))"
    if operator == "G":
        return f"(all1 {y}: {x} <= {y} => ({at(0, y)}))"
    z = new()
    if operator == "U":
        return f"(ex1 {y}: {x} <= {y} & ({at(1, y)}) & (all1 {z}: ({x} <= {z} & {z} < {y}) => ({at(0, z)})))"
    if operator == "M":
        return f"(ex1 {y}: {x} <= {y} & ({at(0, y)}) & (all1 {z}: ({x} <= {z} & {z} <= {y}) => ({at(1, z)})))"
    if operator == "R":
        return f"(all1 {y}: {x} <= {y} => (({at(1, y)}) | (ex1 {z}: {x} <= {z} & {z} < {y} & {at(0, z)})))"
    if operator == "W":
        return f"(all1 {y}: {x} <= {y} => (({at(0, y)}) | (ex1 {z}: {x} <= {z} & {z} <= {y} & {at(1, z)})))"
    raise ValueError(f"operator {operator}")


def mona_program(formula):
    """The program, and the proposition of each of its variables."""
    variables = {f"P{i}": name for i, name in enumerate(sorted(formulas.propositions(formula)))}
    names = {name: variable for variable, name in variables.items()}
    declared = f"var2 {', '.join(variables)};\n" if variables else ""
    return f"m2l-str;\n{declared}ex1 v0: v0 = 0 & ({first_order(formula, 'v0', [0], names)});\n", variables


class Translation:
    def __init__(self, seconds, automaton=None, states=None):
        self.seconds, self.automaton, self.states = seconds, automaton, states
        self.answered = automaton is not None or states is not None


def waymark(folder):
    """Beyond MOST_PROPOSITIONS only sizes are compared: the edges of HOA would take longer than the translation."""
    command = [str(Path(folder) / "waymark"), "translate", "--semantics", "finite", "--dialect", "spot", "--to", "dfa",
               "--threads", "1", "-", "--format"]

    def translate(text, seconds):
        if len(formulas.propositions(formulas.parse(text))) > MOST_PROPOSITIONS:
            answer = run([*command, "stats"], seconds, text + "\n")
            if answer.status != 0:
                return Translation(answer.seconds)
            names, values = (line.split("\t") for line in answer.output.splitlines()[:2])
            return Translation(answer.seconds, None, int(dict(zip(names, values))["states"]))
        answer = run([*command, "json"], seconds, text + "\n")
        if answer.status != 0:
            return Translation(answer.seconds)
        described = json.loads(answer.output)
        return Translation(answer.seconds, words.read_hoa(described["hoa"]), described["automaton"]["states"])

    return translate


def mona(text, seconds):
    program, variables = mona_program(formulas.parse(text))
    with tempfile.NamedTemporaryFile("w", suffix=".mona") as file:
        file.write(program)
        file.flush()
        answer = run(["mona", "-u", "-xw", file.name], seconds)
    if answer.status != 0 or "MONA DFA" not in answer.output:
        return Translation(answer.seconds)
    automaton = words.read_mona(answer.output, variables)
    return Translation(answer.seconds, automaton, automaton.size)


def lydia(text, seconds):
    with tempfile.NamedTemporaryFile("w", suffix=".ltlf") as file:
        file.write(formulas.for_lydia(formulas.parse(text)))
        file.flush()
        answer = run(["lydia", "--logic", "ltlf", "--print", "--file", file.name], seconds)
    if answer.status != 0 or "Initial state" not in answer.output:
        return Translation(answer.seconds)
    return Translation(answer.seconds, words.read_lydia(answer.output))


def ltlf2dfa(text, seconds):
    answer = run(["ltlf2dfa", "--hoaf", f"--formula={text}"], seconds)
    if answer.status != 0 or "--BODY--" not in answer.output:
        return Translation(answer.seconds)
    return Translation(answer.seconds, words.read_hoa(answer.output))


PEERS = {"mona": mona, "lydia": lydia, "ltlf2dfa": ltlf2dfa}
COLUMNS = ("set", "lines", "equal", "sizes only", "not compared", "differ", "waymark states", "states", "waymark s",
           "s", "waymark no answer", "no answer")


def size(translation):
    if translation.states is None:
        translation.states = words.minimal_size(translation.automaton)
    return translation.states


def compare(ours, theirs):
    """A verdict: languages too large to compare letter by letter are compared in size, if the peer tells it."""
    try:
        if not ours.automaton:
            raise words.TooLarge
        word = words.difference(ours.automaton, theirs.automaton)
        if word:
            return f"one of the two accepts {words.show_word(word)}, the other does not"
        verdict = "equal"
    except words.TooLarge:
        if theirs.states is None:
            return "not compared"
        verdict = "sizes only"
    return verdict if size(theirs) == ours.states else f"{ours.states} and {size(theirs)} states"


def row(name, translate, peer, lines, seconds, say):
    """A row of the table, and how many lines differ. States and seconds: of the lines that both answer."""
    counts = dict.fromkeys(COLUMNS, 0) | {"set": name, "lines": len(lines)}
    for number, text in lines:
        ours, theirs = translate(text, seconds), PEERS[peer](text, seconds)
        counts["waymark no answer"] += not ours.answered
        counts["no answer"] += not theirs.answered
        if not (ours.answered and theirs.answered):
            continue
        verdict = compare(ours, theirs)
        counts[verdict if verdict in counts else "differ"] += 1
        if verdict not in counts:
            say(f"{peer}: {name}:{number}: {verdict}: {text}")
        counts["waymark states"] += ours.states
        counts["states"] += theirs.states or 0
        counts["waymark s"] += ours.seconds
        counts["s"] += theirs.seconds
    return counts, counts["differ"]
