"""Deterministic automata on finite words, letter by letter: read from HOA, MONA and Lydia; minimal size, difference.

`step(state, letter)` gives the next state and whether the word may end after the letter; a letter is the set of the
propositions that hold. State None rejects every word. The empty word is no word: nothing depends on it.
"""
import re
from collections import deque
from itertools import combinations

GUARD = re.compile(r"[0-9!&|()tf\s]*")


class Automaton:
    def __init__(self, propositions, initial, step):
        self.propositions, self.initial, self._step = tuple(propositions), initial, step

    def step(self, state, letter):
        return (None, False) if state is None else self._step(state, letter)


def guard_of(text, names):
    """A label of HOA as a function of the letter."""
    if not GUARD.fullmatch(text):
        raise ValueError(f"no guard of HOA: {text}")
    body = re.sub(r"\d+|[tf]", lambda m: {"t": "True", "f": "False"}.get(m[0]) or f"(names[{m[0]}] in letter)", text)
    body = body.replace("!", " not ").replace("&", " and ").replace("|", " or ")
    return eval(f"lambda letter: {body}", {"names": names})  # only digits, operators and parentheses are left


def read_hoa(text):
    """Marks: waymark's (finite-words) stand on the states where words may end, Spot's on the edges that end them."""
    head, _, body = text.partition("--BODY--")
    names = re.findall(r'"((?:[^"\\]|\\.)*)"', re.search(r"AP:\s*\d+([^\n]*?)(?=$|acc-name|Acceptance)", head, re.M)[1])
    on_states = "finite-words" in head
    edges, marked = {}, set()
    for block in re.split(r"State:\s*", body.partition("--END--")[0])[1:]:
        state, mark, rest = re.match(r'(\d+)(?:\s*"[^"]*")?\s*(\{[\d\s]*\})?(.*)', block, re.S).groups()
        if mark:
            marked.add(int(state))
        edges[int(state)] = [(guard_of(guard, names), int(target), bool(on_edge))
                             for guard, target, on_edge in re.findall(r"\[([^\]]*)\]\s*(\d+)\s*(\{[\d\s]*\})?", rest)]

    def step(state, letter):
        for guard, target, on_edge in edges[state]:
            if guard(letter):
                return target, (target in marked) if on_states else (on_edge or state in marked)
        return None, False

    return Automaton(names, int(re.search(r"Start:\s*(\d+)", head)[1]), step)


def read_mona(text, names):
    """`mona -u -xw`, an automaton as a diagram with several terminals; `names` by MONA's names of its variables.

    The first letter in M2L is that of no position, so the automaton begins one step later.
    """
    fields = dict(re.findall(r"^([a-z ]+): ?(.*)$", text, re.M))
    variables = [names[variable] for variable in fields["variables"].split()]
    final, roots = fields["final"].split(), list(map(int, fields["behaviour"].split()))
    nodes = [tuple(map(int, line.split())) for line in text.partition("bdd:\n")[2].partition("end")[0].splitlines()]

    def step(state, letter):
        variable, low, high = nodes[roots[state]]
        while variable >= 0:
            variable, low, high = nodes[high if variables[variable] in letter else low]
        return low, final[low] == "1"

    initial = int(fields["initial"])
    automaton = Automaton(variables, step(initial, frozenset())[0], step)
    # MONA minimises, and all its states are reached: the first one goes with its letter, unless some edge leads back.
    automaton.size = int(fields["states"]) - all(low != initial for variable, low, _ in nodes if variable < 0)
    return automaton


def read_lydia(text):
    """`lydia -p -s`: what Lydia prints of its automaton, as MONA's library does; X stands for both values."""
    names = re.search(r"free variables:(.*)", text)[1].split()
    accepting = set(map(int, re.search(r"Accepting states:(.*)", text)[1].split()))
    edges = {}
    for state, cube, target in re.findall(r"^State (\d+): ([01X]*)\s*-> state (\d+)", text, re.M):
        fixed = [(name, value == "1") for name, value in zip(names, cube) if value != "X"]
        edges.setdefault(int(state), []).append((fixed, int(target)))

    def step(state, letter):
        for fixed, target in edges[state]:
            if all((name in letter) == value for name, value in fixed):
                return target, target in accepting
        return None, False

    return Automaton(names, int(re.search(r"Initial state: (\d+)", text)[1]), step)


def letters(propositions):
    names = sorted(propositions)
    return [frozenset(chosen) for k in range(len(names) + 1) for chosen in combinations(names, k)]


class TooLarge(Exception):
    pass


def minimal_size(automaton, most_steps=2_000_000):
    """States of the minimal complete automaton whose initial state rejects the empty word (docs/conventions.md)."""
    alphabet = letters(automaton.propositions)
    start = (automaton.initial, False)
    table, todo = {start: None}, [start]
    while todo:
        here = todo.pop()
        table[here] = [automaton.step(here[0], letter) for letter in alphabet]
        if len(table) * len(alphabet) > most_steps:
            raise TooLarge
        for there in table[here]:
            if there not in table:
                table[there] = None
                todo.append(there)
    classes, count = {state: int(state[1]) for state in table}, 0
    while len(set(classes.values())) != count:
        count = len(set(classes.values()))
        signatures = {state: (classes[state], *(classes[there] for there in table[state])) for state in table}
        numbers = {signature: i for i, signature in enumerate(set(signatures.values()))}
        classes = {state: numbers[signatures[state]] for state in table}
    return count


def difference(left, right, most_steps=2_000_000):
    """A shortest word that one of the two accepts and the other does not, or None."""
    alphabet = letters(set(left.propositions) | set(right.propositions))
    start = (left.initial, right.initial)
    before, todo = {start: None}, deque([start])
    while todo:
        here = todo.popleft()
        for letter in alphabet:
            (p, accepts_left), (q, accepts_right) = left.step(here[0], letter), right.step(here[1], letter)
            if accepts_left != accepts_right:
                word = [letter]
                while before[here]:
                    here, letter = before[here]
                    word.append(letter)
                return word[::-1]
            if (p, q) not in before:
                before[p, q] = (here, letter)
                todo.append((p, q))
                if len(before) * len(alphabet) > most_steps:
                    raise TooLarge
    return None


def show_word(word):
    return "; ".join("{" + ", ".join(sorted(letter)) + "}" for letter in word)
