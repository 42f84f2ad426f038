"""What a strategy that waymark wrote is worth: its Markov chain, from the documented formats, by SciPy's sparse LU.

`Automaton`, and the models `Grid` (`ltlgrid/1`), `Hallways` (`ltlmap/1`) and `Explicit` (PRISM's `.tra` with `.lab`,
`.srew` and `.trew`) say what leads where; `Chain` follows a strategy through both, `Point` one of two objectives. No
code of waymark takes part. A model has `start`, `first` (the letter read first), `place(NAME)`, `actions(PLACE)` and
`outcomes(PLACE, ACTION)`: the cost of the move, and triples of place, letter and chance; an action is a name, or None
for any.
"""
import json
import re
from array import array

import numpy
from scipy.sparse import csr_matrix, identity
from scipy.sparse.csgraph import connected_components
from scipy.sparse.linalg import splu

DIRECTIONS = "NESW"
STEPS = [(0, -1), (1, 0), (0, 1), (-1, 0)]


class Automaton:
    """A Büchi automaton of the Hanoi format, deterministic but for jumps: next(state, letter), which edges are marked.

    What a jump offers is written among the edges of its source: those that enter the accepting part.
    """

    def __init__(self, text):
        head, body = text.split("--BODY--")
        self.names = re.findall(r'"([^"]*)"', re.search(r"AP: \d+((?: \"[^\"]*\")*)", head)[1])
        self.name = re.search(r'name: "([^"]*)"', head)[1]
        self.start = int(re.search(r"Start: (\d+)", head)[1])
        self.finite = "finite-words" in head
        part, jumps = self.numbers(head, "waymark-accepting-part"), self.numbers(head, "waymark-jumps")
        self.jumps = [*zip(jumps[::2], jumps[1::2])]
        if "acc-name: Buchi" not in head:
            raise SystemExit(f"error: not a Büchi automaton: {head}")
        self.marked, self.edges, self.known = set(), {}, {}
        for state, mark, edges in re.findall(r"State: (\d+)( \{0\})?((?: *\[[^]]*\] \d+(?: \{0\})?)*)", body):
            self.marked.update([int(state)] if mark else [])
            self.edges[int(state)] = [(self.condition(label), int(target), bool(edge_mark)) for label, target, edge_mark
                                      in re.findall(r"\[([^]]*)\] (\d+)( \{0\})?", edges)
                                      if int(state) in part or int(target) not in part]

    @staticmethod
    def numbers(head, name):
        found = re.search(rf"{name}:((?: \d+)*)", head)
        return [int(number) for number in found[1].split()] if found else []

    @staticmethod
    def condition(label):
        if label == "t":
            return "True"
        return re.sub(r"\d+", lambda n: f"v[{n[0]}]", label.replace("!", " not ").replace("&", " and ")
                      .replace("|", " or ")).strip()

    def next(self, state, letter):
        """The next state, and whether the edge is marked; (None, False) when there is no edge."""
        found = self.known.get((state, letter))
        if found is None:
            v = [name in letter for name in self.names]
            fits = [(target, mark) for condition, target, mark in self.edges[state] if eval(condition, {"v": v})]
            if len(fits) > 1:
                raise SystemExit("error: the automaton is not deterministic")
            target, mark = fits[0] if fits else (None, False)
            found = self.known[state, letter] = (target, bool(mark or state in self.marked))
        return found


class Grid:
    """Where a move may lead, from `ltlgrid/1`."""

    def __init__(self, case):
        self.rows, self.legend = case["rows"], {".": {}, **case["legend"]}
        self.letters = {glyph: frozenset(cell.get("props", [])) for glyph, cell in self.legend.items()}
        self.start = (case["start"]["x"], case["start"]["y"])
        self.first = self.letter(self.start)
        motion = case.get("motion", {"forward": 1})
        self.chances = [motion.get(key, 0) for key in ("forward", "right", "back", "left")]
        self.cost = case.get("cost", {}).get("step", 1)

    @staticmethod
    def place(name):
        x, y = name.split(",")
        return int(x), int(y)

    def cell(self, at):
        x, y = at
        inside = 0 <= y < len(self.rows) and 0 <= x < len(self.rows[y])
        return self.legend[self.rows[y][x]] if inside else {"wall": True}

    def letter(self, at):
        return self.letters[self.rows[at[1]][at[0]]]

    def moved(self, at, direction):
        to = (at[0] + STEPS[direction][0], at[1] + STEPS[direction][1])
        here, there = self.cell(at), self.cell(to)
        ways = (here.get("oneway"), there.get("oneway"))
        barred = there.get("wall") or any(way and way != DIRECTIONS[direction] for way in ways)
        return at if barred else to

    @staticmethod
    def actions(_):
        return DIRECTIONS

    def outcomes(self, at, action):
        chosen = DIRECTIONS.index(action) if action else 0
        reached = [(self.moved(at, (chosen + turn) % 4), p) for turn, p in enumerate(self.chances) if p > 0]
        return self.cost, [(to, self.letter(to), p) for to, p in reached]


class Hallways:
    """Nodes and headings of `ltlmap/1`; actions that do not slip are all that is read."""

    def __init__(self, case):
        if "motion" in case:
            raise SystemExit("error: a hallway map whose moves slip")
        self.props = {node["id"]: node.get("props", []) for node in case["nodes"]}
        self.ways = {}
        for edge in case["edges"]:
            towards = DIRECTIONS.index(edge["dir"])
            for near, far, heading in ((edge["from"], edge["to"], towards), (edge["to"], edge["from"], towards + 2)):
                self.ways[near, heading % 4] = (far, edge.get("props", []))
        self.start = (case["start"]["node"], DIRECTIONS.index(case["start"]["heading"]))
        self.first = self.letter(self.start)
        self.cost = case.get("cost", {}).get("step", 1)
        self.names = {f"{node},{DIRECTIONS[heading]}": (node, heading) for node in self.props for heading in range(4)}

    def place(self, name):
        return self.names[name]

    def letter(self, at):
        ahead = self.ways.get(at, (None, []))[1]
        return frozenset([*self.props[at[0]], *(f"face_{name}" for name in ahead)])

    def actions(self, at):
        return ["left", "right", *(["forward"] if at in self.ways else [])]

    def outcomes(self, at, action):
        node, heading = at
        turn = {"left": 3, "right": 1, "forward": 0, None: 1}[action]
        to = (node, (heading + turn) % 4) if turn else (self.ways[at][0], heading)
        return self.cost, [(to, self.letter(to), 1.0)]


class Explicit:
    """PRISM's explicit files of a Markov decision process, PREFIX.tra and those beside it."""

    def __init__(self, prefix):
        def lines(kind):
            file = prefix.with_suffix(kind)
            return [line.split() for line in file.read_text().splitlines() if line.strip()] if file.exists() else []

        states = int(lines(".tra")[0][0])
        self.choices = [{} for _ in range(states)]
        names = {}
        for source, choice, target, chance, *action in lines(".tra")[1:]:
            self.choices[int(source)].setdefault(int(choice), []).append((int(target), float(chance)))
            names[int(source), int(choice)] = action[0] if action else choice
        self.named = [{names[s, k]: k for k in choices} for s, choices in enumerate(self.choices)]
        numbers, *rows = prefix.with_suffix(".lab").read_text().splitlines()
        label = {number: name for number, name in re.findall(r'(\d+)="([^"]*)"', numbers)}
        letters = [set() for _ in range(states)]
        for state, those in (row.split(":") for row in rows if row):
            letters[int(state)] = {label[number] for number in those.split()}
        self.start = next(state for state, letter in enumerate(letters) if "init" in letter)
        self.letters = [frozenset(letter - {"init", "deadlock"}) for letter in letters]
        self.first = self.letters[self.start]
        self.rewards = [0.0] * states
        for state, reward in lines(".srew")[1:]:
            self.rewards[int(state)] = float(reward)
        self.moves = {(int(row[0]), int(row[1]), int(row[2])): float(row[3]) for row in lines(".trew")[1:]}
        if not lines(".srew") and not lines(".trew"):
            self.rewards = [1.0] * states

    @staticmethod
    def place(name):
        return int(name)

    def actions(self, at):
        return [*self.named[at]] or [None]

    def outcomes(self, at, action):
        choices = self.choices[at]
        if not choices:
            return self.rewards[at], [(at, self.letters[at], 1.0)]
        choice = self.named[at][action] if action is not None else next(iter(choices))
        rewards = sum(p * self.moves.get((at, choice, to), 0.0) for to, p in choices[choice])
        return self.rewards[at] + rewards, [(to, self.letters[to], p) for to, p in choices[choice]]


def model_of(file):
    if file.suffix == ".tra":
        return Explicit(file)
    case = json.loads(file.read_text())
    return Grid(case) if case["format"] == "ltlgrid/1" else Hallways(case)


class Pairs:
    """A Markov chain of pairs of place and memory, the start first."""

    def __init__(self):
        self.sources, self.targets, self.chances, self.costs = array("i"), array("i"), array("d"), array("d")
        self.number, self.pairs, self.goals, self.matrix = {}, [], [], None

    def meet(self, pair):
        number = self.number.setdefault(pair, len(self.pairs))
        if number == len(self.pairs):
            self.pairs.append(pair)
        return number

    def add(self, source, pair, p):
        self.sources.append(source)
        self.targets.append(self.meet(pair))
        self.chances.append(p)

    def finish(self):
        entries = (numpy.array(self.chances), (numpy.array(self.sources), numpy.array(self.targets)))
        self.matrix = csr_matrix(entries, shape=(len(self.pairs),) * 2)

    def bottom(self):
        """The number of the strongly connected component of each pair, and which of these are never left."""
        count, of = connected_components(self.matrix, connection="strong")
        leaves = numpy.zeros(count, bool)
        rows, columns = self.matrix.nonzero()
        leaves[of[rows[of[rows] != of[columns]]]] = True
        return of, ~leaves

    def reaching(self, targets):
        """Which pairs may reach these: true and false."""
        backwards = csr_matrix(self.matrix.T)
        reached = numpy.zeros(len(self.pairs), bool)
        reached[targets] = True
        front = numpy.array(targets, int)
        while front.size:
            near = backwards[front].indices
            front = numpy.unique(near[~reached[near]])
            reached[front] = True
        return reached

    def blocks(self, unknown):
        """Those of `unknown` in parts, each after all that it leads to: by components of the automaton's states."""
        states = {}
        of = numpy.array([states.setdefault(state, len(states)) for _, state in self.pairs])
        sources, targets = self.matrix.nonzero()
        leads = csr_matrix((numpy.ones(sources.size), (of[sources], of[targets])), shape=(len(states),) * 2)
        count, part = connected_components(leads, connection="strong")
        rows, columns = leads.nonzero()
        after = [set() for _ in range(count)]
        for row, column in zip(part[rows], part[columns]):
            if row != column:
                after[row].add(column)
        order, placed = [], set()
        while len(order) < count:
            ready = [k for k in range(count) if k not in placed and after[k] <= placed]
            order += ready
            placed.update(ready)
        for k in order:
            inside = numpy.flatnonzero(unknown & (part[of] == k))
            if inside.size:
                yield inside

    def worth(self, kind, discount=None):
        """From the start: the "chance" to come to a goal, the expected "cost" until then, or the "discounted" one,
        γ^(moves − 1)."""
        won = numpy.zeros(len(self.pairs), bool)
        won[self.goals] = True
        some = self.reaching(self.goals)
        if kind == "chance":
            won = ~self.reaching(numpy.flatnonzero(~some))  # almost surely
        elif kind == "cost" and not some.all():
            return numpy.inf
        if kind == "discounted" and won[0]:
            return 1.0
        value = numpy.where(won, {"chance": 1.0, "cost": 0.0, "discounted": 1.0 / (discount or 1)}[kind], 0.0)
        share = discount if kind == "discounted" else 1.0
        earned = numpy.array(self.costs) if kind == "cost" else numpy.zeros(len(self.pairs))
        for block in self.blocks(some & ~won):
            kept = self.matrix[block] * share
            known = earned[block] + kept @ value
            system = (identity(block.size) - kept[:, block]).tocsc()
            factors = splu(system)
            found = factors.solve(known)
            found += factors.solve(known - system @ found)  # one step of refinement
            value[block] = found
        return value[0]


class Chain(Pairs):
    """The pairs that a strategy meets, from the start on; where it says nothing, any move is as good."""

    def __init__(self, model, head, decisions):
        super().__init__()
        automaton, marks = Automaton(head["automaton"]), set()
        chosen = {(model.place(state), task): move for state, task, move in decisions}
        begins = [automaton.start] + [to for source, to in automaton.jumps if source == automaton.start]
        firsts = [automaton.next(state, model.first)[0] for state in begins]
        first = decisions[0][1] if decisions else firsts[0]
        if first not in firsts or (decisions and model.place(decisions[0][0]) != model.start):
            raise SystemExit("error: a strategy that begins elsewhere")
        self.meet((model.start, first))
        for source, pair in enumerate(self.pairs):  # which grow
            at, state = pair
            move = chosen.get(pair)
            self.costs.append(0.0)
            if state is None or (automaton.finite and state in automaton.marked and move is None):
                self.goals += [source] if state is not None else []
                self.add(source, pair, 1.0)
            elif isinstance(move, int):
                if (state, move) not in automaton.jumps:
                    raise SystemExit("error: a jump that the automaton does not have")
                self.add(source, (at, move), 1.0)
            else:
                self.costs[source], reached = model.outcomes(at, move)
                for to, letter, p in reached:
                    target, mark = automaton.next(state, letter)
                    self.add(source, (to, target), p)
                    if mark:
                        marks.add(source)
        self.finish()
        self.goals = sorted({*self.goals, *self.recurrent(marks)})
        self.negated = head["query"] == "pmin" and not automaton.finite
        if self.negated != (automaton.name == f"!({head['formula']})"):
            raise SystemExit(f"error: {head['query']} of {head['formula']} with an automaton of {automaton.name}")

    def recurrent(self, marked):
        """Pairs of bottom components with a marked edge."""
        of, bottom = self.bottom()
        wins = numpy.zeros(bottom.size, bool)
        wins[of[list(marked)]] = True
        return numpy.flatnonzero((wins & bottom)[of]).tolist()

    def value(self, kind, discount=None):
        """What the strategy is worth. The automaton of a least chance is that of the negation where words have no end.
        """
        return 1 - self.worth(kind, discount) if self.negated else self.worth(kind, discount)


class Point(Pairs):
    """A strategy for two objectives: its memory is what became of each formula `!x U y`, given as (x, y), x or None.
    """

    def __init__(self, model, formulas, decisions):
        super().__init__()
        chosen = {(model.place(d["state"]), tuple(self.known(m) for m in d["memory"].split(",") if m)): d["action"]
                  for d in decisions}
        self.meet((model.start, self.after(formulas, (None,) * len(formulas), model.first)))
        for source, pair in enumerate(self.pairs):  # which grow
            cost, reached = model.outcomes(pair[0], chosen[pair])
            self.costs.append(cost)
            for to, letter, p in reached:
                self.add(source, (to, self.after(formulas, pair[1], letter)), p)
        self.finish()

    @staticmethod
    def known(memory):
        return {"yes": True, "no": False}.get(memory)

    @staticmethod
    def after(formulas, memory, letter):
        return tuple((True if goal in letter else False if avoided in letter else None) if known is None else known
                     for known, (avoided, goal) in zip(memory, formulas))

    def chance(self, formula):
        self.goals = [number for number, (_, memory) in enumerate(self.pairs) if memory[formula]]
        return self.worth("chance")

    def total_cost(self):
        of, bottom = self.bottom()
        ends = bottom[of]
        if numpy.array(self.costs)[ends].any():
            return numpy.inf
        self.goals = numpy.flatnonzero(ends).tolist()
        return self.worth("cost")


def strategies(file):
    """The first lines of a file of strategies, each with its decisions: state, task, and an action or where to jump."""
    out = []
    with open(file) as lines:
        for line in map(json.loads, lines):
            if "automaton" in line:
                out.append((line, []))
            else:
                out[-1][1].append((line["state"], line["task"], line["jump"] if "jump" in line else line["action"]))
    return out
