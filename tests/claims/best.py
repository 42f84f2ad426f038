"""The best value of a task by policy iteration, whose last answer proves itself: in chains.py's words of models.

`Product` has every pair of place and automaton state that some choice of actions leads to. `best` solves each policy by
SciPy's sparse LU and takes better actions until there is none [Put94, §6.4]. That no other policy is better then
follows from the values alone, up to STRICT a move: they satisfy Bellman's inequalities in every pair and for every
action, and are those of a policy. No code of waymark takes part but the automaton, which the claims of automata are
about.
"""
import numpy
from scipy.sparse import csr_matrix, identity
from scipy.sparse.csgraph import connected_components
from scipy.sparse.linalg import splu

from chains import Automaton

LOST = (None, None)
STRICT = 1e-12  # of a value, or of 1 where that is more; what an action must be better by
MOST_POLICIES = 1000


class Product:
    """`owner` and `cost` of each action, `matrix` of its chances; the pairs that are goals, and actions with a marked
    outcome."""

    def __init__(self, model, head):
        automaton = Automaton(head["automaton"])
        self.finite, self.pairs, self.number = automaton.finite, [], {}
        self.owner, self.cost, self.marked, self.goals = [], [], [], []
        entries = []
        begins = [automaton.start] + [to for source, to in automaton.jumps if source == automaton.start]
        firsts = [automaton.next(state, model.first)[0] for state in begins]
        self.starts = [self.meet((model.start, state)) for state in firsts]
        for source, (at, state) in enumerate(self.pairs):  # which grow
            if self.finite and state in automaton.marked:
                self.goals.append(source)
                continue
            for jump in (to for left, to in automaton.jumps if left == state):
                entries.append((self.action(source, 0.0), self.meet((at, jump)), 1.0))
            for action in model.actions(at) if state is not None else []:
                cost, reached = model.outcomes(at, action)
                row = self.action(source, cost)
                for to, letter, p in reached:
                    target, mark = automaton.next(state, letter)
                    entries.append((row, self.meet((to, target)), p))
                    self.marked[row] |= mark
        self.owner, self.cost, self.marked = map(numpy.array, (self.owner, self.cost, self.marked))
        rows, columns, chances = map(numpy.array, zip(*entries))
        self.matrix = csr_matrix((chances, (rows, columns)), shape=(self.owner.size, len(self.pairs)))
        self.rows, self.columns = self.matrix.nonzero()

    def meet(self, pair):
        pair = LOST if pair[1] is None else pair
        number = self.number.setdefault(pair, len(self.pairs))
        if number == len(self.pairs):
            self.pairs.append(pair)
        return number

    def action(self, source, cost):
        self.owner.append(source)
        self.cost.append(cost)
        self.marked.append(False)
        return len(self.owner) - 1

    def some_in(self, pairs):
        """Of each action, whether an outcome is in this set of pairs."""
        found = numpy.zeros(self.owner.size, bool)
        found[self.rows[pairs[self.columns]]] = True
        return found

    def with_action(self, actions):
        """The pairs that have one of these actions."""
        found = numpy.zeros(len(self.pairs), bool)
        found[self.owner[actions]] = True
        return found

    def attracted(self, targets, allowed):
        """The pairs that may come to a target by allowed actions, and for each the action likeliest to come nearer."""
        reached, policy = targets.copy(), numpy.full(len(self.pairs), -1)
        while True:
            nearer = numpy.flatnonzero(allowed & self.some_in(reached) & ~reached[self.owner])
            if not nearer.size:
                return reached, policy
            nearer = nearer[numpy.argsort(self.matrix[nearer] @ reached, kind="stable")]  # the likeliest last
            policy[self.owner[nearer]] = nearer
            reached[self.owner[nearer]] = True

    def goal_set(self):
        goals = numpy.zeros(len(self.pairs), bool)
        goals[self.goals] = True
        return goals

    def recurring(self):
        """The pairs of maximal end components that have a marked action [BK08, Alg. 47]."""
        inside = numpy.ones(self.owner.size, bool)
        while True:
            kept = inside[self.rows]
            graph = csr_matrix((numpy.ones(kept.sum()), (self.owner[self.rows[kept]], self.columns[kept])),
                               shape=(len(self.pairs),) * 2)
            count, of = connected_components(graph, connection="strong")
            left = self.rows[of[self.columns] != of[self.owner[self.rows]]]
            after = inside.copy()
            after[left] = False
            after &= ~self.some_in(~self.with_action(after))
            if (after == inside).all():
                break
            inside = after
        wins = numpy.zeros(count, bool)
        wins[of[self.owner[inside & self.marked]]] = True
        return wins[of] & self.with_action(inside)

    def can_avoid(self, goals):
        """The pairs that some policy keeps from the goals for ever."""
        safe = ~goals
        ends = ~self.with_action(numpy.ones(self.owner.size, bool))
        while True:
            after = safe & (ends | self.with_action(~self.some_in(~safe)))
            if (after == safe).all():
                return safe
            safe = after

    def surely(self, goals):
        """The pairs from which a policy comes to the goals with probability 1, and the actions that stay there."""
        inside = numpy.ones(len(self.pairs), bool)
        while True:
            allowed = ~self.some_in(~inside)
            after, _ = self.attracted(goals, allowed)
            if (after == inside).all():
                return inside, allowed
            inside = after


def iterated(product, value, unknown, policy, allowed, sign, share, costs):
    """Writes the values of the unknown pairs: policies, from a proper one, until none is better by the share STRICT."""
    index = numpy.flatnonzero(unknown)
    candidates = numpy.flatnonzero(allowed & unknown[product.owner])
    owner, matrix = product.owner[candidates], product.matrix[candidates] * share
    for _ in range(MOST_POLICIES):
        chosen = policy[index]
        kept = product.matrix[chosen] * share
        known = costs[chosen] + kept @ numpy.where(unknown, 0.0, value)
        system = (identity(index.size) - kept[:, index]).tocsc()
        factors = splu(system)
        found = factors.solve(known)
        value[index] = found + factors.solve(known - system @ found)  # one step of refinement
        gains = sign * (costs[candidates] + matrix @ value - value[owner]) / numpy.maximum(1, numpy.abs(value[owner]))
        better = gains > STRICT
        if not better.any():
            return
        order = numpy.argsort(gains[better], kind="stable")  # the best of a pair is written last
        policy[owner[better][order]] = candidates[better][order]
    raise SystemExit(f"error: policy iteration does not end: better by {gains.max():.1e} in {better.sum()} pairs")


def best(model, head, discount):
    """The number of pairs, and the best value of the task from the start."""
    product = Product(model, head)
    everything = numpy.ones(product.owner.size, bool)
    goals = product.goal_set() if product.finite else product.recurring()
    value, nothing = numpy.zeros(len(product.pairs)), numpy.zeros(product.owner.size)
    query = head["query"]
    if query in ("rmin", "steps"):
        inside, allowed = product.surely(goals)
        value[~inside] = numpy.inf
        _, policy = product.attracted(goals, allowed)
        costs = product.cost if query == "rmin" else numpy.ones(product.owner.size)
        finite = numpy.where(inside, value, 0.0)
        iterated(product, finite, inside & ~goals, policy, allowed, -1, 1.0, costs)
        value = numpy.where(inside, finite, numpy.inf)
        return len(product.pairs), value[product.starts].min()
    if query == "pmin" and product.finite:
        safe = product.can_avoid(goals)
        escaping, _ = product.attracted(safe, everything)
        value[~escaping] = 1.0  # whatever is done
        unknown = escaping & ~safe
        policy = numpy.full(len(product.pairs), -1)
        policy[product.owner] = numpy.arange(product.owner.size)
        iterated(product, value, unknown, policy, everything, -1, 1.0, nothing)
        return len(product.pairs), value[product.starts].min()
    share = discount if query == "discounted" else 1.0
    value[goals] = 1 / share
    reached, policy = product.attracted(goals, everything)
    iterated(product, value, reached & ~goals, policy, everything, 1, share, nothing)
    found = 1.0 if query == "discounted" and goals[product.starts[0]] else value[product.starts].max()
    return len(product.pairs), 1 - found if query == "pmin" else found
