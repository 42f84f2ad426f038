"""waymark: from English route instructions to certified routes, through linear temporal logic.

    import waymark as wm
    answer = wm.run("walk past the lamp to the easel", map="grid", start=(1, 9, 0))
    answer.understood, answer.formula, answer.route.poses

Formulas are `Formula` objects; where a function takes a formula, the text of one does as well. A letter is a set of
names, or a text such as "{a, b}"; a word is a sequence of letters, or a text such as "{a}; {b}; {}".
"""
from __future__ import annotations

import os
import subprocess
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Iterable, Sequence, Union

from . import _waymark
from ._waymark import (Dfa, FormatError, Formula, LimitDeterministic, LimitError, Map, Model, NoRoute, OmegaAutomaton,
                       ParseError, Product, Reading, Route, Understanding, follow, from_hoa, random_formulas)

__version__ = _waymark.version
__all__ = [
    "Answer", "Dfa", "Explanation", "FormatError", "Formula", "LimitDeterministic", "LimitError", "Map", "Model",
    "Monitor", "NoRoute", "NotUnderstood", "OmegaAutomaton", "ParseError", "Product", "Reading", "Route",
    "Understanding", "accepts", "draw", "explain", "follow", "from_hoa", "ground", "load_map", "load_model", "monitor",
    "parse", "plan", "progress", "random_formulas", "run", "simplify", "translate"
]

_HERE = Path(__file__).parent
Letter = Union[str, Iterable[str]]
Word = Union[str, Sequence[Letter]]
Automaton = Union[Dfa, OmegaAutomaton, LimitDeterministic]
Start = Union[None, str, Sequence[int]]


class NotUnderstood(ValueError):
    """The text was not understood; `words` name nothing here, `probability` is that of having understood."""

    def __init__(self, text: str, understanding: Understanding):
        self.words = list(understanding.unknown_words)
        self.probability = understanding.probability
        about = "; nothing here is called " + ", ".join(repr(word) for word in self.words) if self.words else ""
        super().__init__(f"not understood: {text!r}{about}")


# ---- formulas

def parse(text: str | Formula, notation: str = "infix", dialect: str = "waymark",
          propositions: Sequence[str] | None = None) -> Formula:
    """The formula of a text; a Formula is returned as it is."""
    return text if isinstance(text, Formula) else Formula(text, notation, dialect, propositions)


def simplify(formula: str | Formula, semantics: str = "finite") -> Formula:
    """A formula that holds on the same words and is no larger."""
    return parse(formula).simplify(semantics)


def progress(formula: str | Formula, letter: Letter, semantics: str = "finite") -> Formula:
    """What remains of the formula after the letter."""
    return parse(formula).progress(letter, semantics)


def translate(formula: str | Formula, to: str = "dfa", limit_states: int = 1_000_000) -> Automaton:
    """The automaton of a formula: 'dfa' over finite words; 'tgba', 'buchi', 'parity', 'rabin', 'generic', 'ldba' over
    infinite ones."""
    return _waymark.translate(parse(formula), to, limit_states)


def accepts(task: str | Formula | Automaton, word: Word, cycle: Sequence[Letter] | None = None) -> bool:
    """Does the word satisfy the formula, or does the automaton accept it? With a cycle the word is infinite."""
    if isinstance(task, (str, Formula)):
        return parse(task).holds(word, cycle)
    return task.accepts(word) if isinstance(task, Dfa) else task.accepts(word, cycle)


class Monitor:
    """The verdict about a formula while letters come in.

    Over infinite words `verdict` is 'true' (whatever follows), 'false' (whatever follows) or 'open'. Over finite words
    the verdict is 'true' or 'false' once no continuation changes it, and `holds_now` says what holds if the word ended
    here. `remains` is what remains of the formula. The conjuncts of a formula are monitored apart: hundreds are no more
    work than their sum.
    """

    def __init__(self, formula: str | Formula, semantics: str = "infinite", limit_states: int = 1_000_000):
        if semantics not in ("finite", "infinite"):
            raise ValueError(f"semantics is 'finite' or 'infinite', not {semantics!r}")
        self.formula = parse(formula)
        self.semantics = semantics
        self._monitor = _waymark.Monitor(self.formula, semantics, limit_states)
        self.letters = 0
        self.remains = self.formula

    def reset(self) -> None:
        """Forgets all letters."""
        self.letters = 0
        self.remains = self.formula
        self._monitor.reset()

    def read(self, letter: Letter) -> str:
        """Reads one letter; returns the verdict."""
        self.letters += 1
        self.remains = self.remains.progress(letter, self.semantics)
        return self._monitor.read(letter)

    @property
    def verdict(self) -> str:
        """'true', 'false' or 'open'."""
        return self._monitor.verdict

    @property
    def is_known_satisfiable(self) -> bool:
        """False: open, but whether some continuation satisfies the formula was not found out within the budget."""
        return self._monitor.is_known_satisfiable

    @property
    def holds_now(self) -> bool:
        """Does the word so far satisfy the formula? Over finite words, after one letter or more."""
        if self._monitor.holds_now is None:
            raise ValueError("asked of a finite word of one letter or more")
        return self._monitor.holds_now


def monitor(formula: str | Formula, semantics: str = "infinite") -> Monitor:
    """A monitor that has read nothing yet."""
    return Monitor(formula, semantics)


@dataclass(frozen=True)
class Explanation:
    """What a formula means: in English, by a word that satisfies it, and by one that does not (None: there is none).

    Words over infinite words are pairs (prefix, cycle)."""
    formula: Formula
    english: str
    satisfying: object
    violating: object


def explain(formula: str | Formula, semantics: str = "finite", map: str | Map | None = None) -> Explanation:
    """The formula in English, with a word that satisfies it and one that does not."""
    phi = parse(formula)
    english = phi.english(semantics, load_map(map) if map is not None else None)
    if semantics == "finite":
        yes, no = (translate(f, "dfa").shortest_word() for f in (phi, ~phi))
    else:
        yes, no = (translate(f, "tgba").find_word() for f in (phi, ~phi))
    return Explanation(phi, english, yes, no)


# ---- maps, models, routes

def _data() -> str:
    return os.environ.get("WAYMARK_DATA") or str(_HERE / "share")


@lru_cache(maxsize=None)
def _shipped_map(name: str, data: str) -> Map:
    return Map(name, data)


def load_map(map: str | Map) -> Map:
    """A map by its name ('grid', 'jelly', 'l') or from a file; a Map is returned as it is."""
    if isinstance(map, Map):
        return map
    return Map(map, _data()) if os.path.exists(map) else _shipped_map(map, _data())


@lru_cache(maxsize=None)
def _shipped_model(data: str) -> Model:
    return Model(str(Path(data) / "models" / "encoder-decoder.waymark"))


def load_model(file: str | None = None) -> Model:
    """A model from a file, or the one that comes with waymark."""
    return Model(file) if file is not None else _shipped_model(_data())


def _start(start: Start, map: Map) -> str:
    if start is None:
        return map.first_start
    return start if isinstance(start, str) else ",".join(str(int(number)) for number in start)


def ground(text: str, map: str | Map = "grid", start: Start = None, *, top: int = 5, force: bool = False,
           model: Model | None = None) -> Understanding:
    """The formulas that the text may mean on the map, said at the start pose, the likeliest first."""
    here = load_map(map)
    return (model or load_model()).read(text, here, _start(start, here), top, force)


def plan(task: str | Formula | Dfa, map: str | Map = "grid", start: Start = None, *, semantics: str = "finite",
         order: str = "prefix") -> Route | NoRoute:
    """The certified route of least cost, or the proof that there is none (false in conditions).

    Over infinite words the route is a lasso. `start` is (x, y, heading), or (x, y) for any heading."""
    here = load_map(map)
    if isinstance(task, Dfa):
        return _waymark.plan_automaton(task, here, _start(start, here))
    if semantics == "finite":
        return _waymark.plan_formula(parse(task), here, _start(start, here))
    if semantics == "infinite":
        return _waymark.plan_lasso(parse(task), here, _start(start, here), order)
    raise ValueError(f"semantics is 'finite' or 'infinite', not {semantics!r}")


@dataclass(frozen=True)
class Answer:
    """The answer to an instruction, through all stages."""
    text: str
    understood: str
    formula: Formula
    readings: list[Reading]
    semantics: str
    automaton: Dfa | OmegaAutomaton
    map: Map
    route: Route | NoRoute

    def _repr_svg_(self) -> str:
        return draw(self.map, self.route, instruction=self.text, formula=self.formula, automaton=self.automaton)


def run(text: str, map: str | Map = "grid", start: Start = None, *, semantics: str = "auto", force: bool = False,
        model: Model | None = None) -> Answer:
    """Reads the instruction, plans the likeliest reading, and certifies the route. Raises NotUnderstood."""
    here = load_map(map)
    understanding = ground(text, here, start, force=force, model=model)
    if not understanding:
        raise NotUnderstood(text, understanding)
    phi = understanding.readings[0].formula
    if semantics == "auto":
        semantics = "infinite" if understanding.ongoing else "finite"
    route = plan(phi, here, start, semantics=semantics)
    automaton = translate(phi, "dfa" if semantics == "finite" else "tgba")
    return Answer(text, phi.english(semantics, here), phi, understanding.readings, semantics, automaton, here, route)


# ---- pictures

def _layout(dot: str) -> str:
    """The SVG of a DOT text, laid out by the helper waymark-layout, which links Graphviz."""
    program = _HERE / "libexec" / "waymark-layout"
    if not program.exists():
        return ""
    done = subprocess.run([str(program), "rankdir=TB", "nodesep=0.5", "ranksep=0.6"], input=dot.encode(),
                          stdout=subprocess.PIPE, check=True)
    return done.stdout.decode()


def _picture_of(automaton: Automaton | None) -> str:
    if automaton is None:
        return ""
    try:
        return _layout(automaton.dot())
    except LimitError:  # too many edges to be read
        return ""


def draw(map: str | Map, route: Route | NoRoute | None = None, *, instruction: str = "",
         formula: str | Formula | None = None, automaton: Automaton | None = None) -> str:
    """The picture of a map as SVG, with the route, the formula and the automaton where they are given."""
    shown = route if isinstance(route, Route) else None
    phi = parse(formula) if formula is not None else None
    return _waymark.page(load_map(map), shown, instruction, phi, _picture_of(automaton))


def _svg_of_automaton(self: Automaton) -> str | None:
    return _picture_of(self) or None


Map._repr_svg_ = lambda self: draw(self)
Route._repr_svg_ = lambda self: draw(self.map, self)
Formula._repr_svg_ = lambda self: _svg_of_automaton(translate(self))
for _kind in (Dfa, OmegaAutomaton, LimitDeterministic):
    _kind._repr_svg_ = _svg_of_automaton
