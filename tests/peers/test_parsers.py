"""What the peers print, as recorded or as their documentation shows it, and what is made of it here."""
import itertools
import math
import sys
import unittest

sys.dont_write_bytecode = True
import finite
import formulas
import omega
import planning
import run
import words

# waymark translate 'F (a & X[!] b)' --semantics finite --dialect spot --to dfa
WAYMARK = """HOA: v1
name: "F(a & X b)"
States: 3
Start: 0
AP: 2 "a" "b"
acc-name: Buchi
Acceptance: 1 Inf(0)
properties: trans-labels explicit-labels state-acc complete deterministic finite-words
--BODY--
State: 0
[!0] 0
[0] 1
State: 1
[!0&!1] 0
[1] 2
[0&!1] 1
State: 2 {0}
[t] 2
--END--
"""
# mona -u -xw, version 1.4-18, on the program of the same formula
MONA = """MONA DFA
number of variables: 2
variables: P0 P1
orders: 2 2
states: 4
initial: 0
bdd nodes: 7
final: -1 -1 -1 1
behaviour: 0 1 3 5
bdd:
 -1 1 0
 0 0 2
 -1 2 0
 0 6 4
 1 2 5
 -1 3 0
 1 0 5
end
"""
# Spot's ltlf2dfa, b M a and b U a: marks on edges, and on states when all edges that leave them have it
SPOT_ON_EDGES = """HOA: v1 name: "b M a" States: 2 Start: 0 AP: 2 "a" "b" acc-name: Buchi Acceptance: 1 Inf(0)
properties: trans-labels explicit-labels trans-acc deterministic
--BODY-- State: 0 [0&!1] 0 [0&1] 1 {0} State: 1 [t] 1 {0} --END--"""
SPOT_ON_STATES = """HOA: v1 name: "G a" States: 1 Start: 0 AP: 1 "a" acc-name: Buchi Acceptance: 1 Inf(0)
properties: trans-labels explicit-labels state-acc colored deterministic --BODY-- State: 0 {0} [0] 0 --END--"""
# what Lydia's dfaPrint writes, for F a
LYDIA = """[info] Computed automaton:
DFA for formula with free variables: a
Initial state: 0
Accepting states: 1
Rejecting states: 0

Automaton has 2 state(s) and 3 BDD-node(s)
Transitions:
State 0: 0 -> state 0
State 0: 1 -> state 1
State 1: X -> state 1
"""
PRISM = """Model checking: "reach": Pmax=? [ F "a" ]

Building model (engine:explicit)...
Value in the initial state: 0.5004882

Time for model checking: 0.71 seconds.

Result: 0.5004882 (+/- 4.9E-7 estimated; rel err 9.8E-7)

---------------------------------------------------------------------

Model checking: "cost_rmin": R{"cost"}min=? [ F "a" ]

Result: Infinity
"""
AUTCROSS = '''"input.source","input.name","tool","exit_status","exit_code","time","output.states","output.edges"
"-:1.1-46.7","automaton 0","waymark buchi","ok",0,0.0217727,26,91
"-:1.1-46.7","automaton 0","Spot","ok",0,0.00293471,34,121
"-:47.1-94.7","automaton 1","waymark buchi","timeout",-1,8.1,,
'''


class Readers(unittest.TestCase):
    def test_mona_and_waymark_agree(self):
        theirs = words.read_mona(MONA, {"P0": "a", "P1": "b"})
        self.assertEqual(theirs.size, 3)
        self.assertEqual(words.minimal_size(theirs), 3)
        self.assertIsNone(words.difference(words.read_hoa(WAYMARK), theirs))

    def test_a_difference_is_a_shortest_word(self):
        wrong = words.read_hoa(WAYMARK.replace("[1] 2\n", "[1] 0\n"))
        self.assertEqual(words.show_word(words.difference(words.read_hoa(WAYMARK), wrong)), "{a}; {b}")

    def test_marks_of_spot(self):
        self.assertEqual(words.minimal_size(words.read_hoa(SPOT_ON_EDGES)), 3)  # with the state that rejects
        self.assertEqual(words.minimal_size(words.read_hoa(SPOT_ON_STATES)), 3)
        word = words.difference(words.read_hoa(SPOT_ON_STATES), words.read_hoa(SPOT_ON_EDGES))
        self.assertEqual(words.show_word(word), "{a}")

    def test_lydia(self):
        theirs = words.read_lydia(LYDIA)
        self.assertEqual(theirs.propositions, ("a",))
        self.assertEqual(words.minimal_size(theirs), 2)

    def test_prism(self):
        self.assertEqual(planning.values_of(PRISM), {"reach": 0.5004882, "cost_rmin": math.inf})
        mine = planning.ours('{"task":"reach","query":"pmax","value":0.5004889}\n{"task":"cost_rmin","query":"rmin",'
                             '"status":"infeasible"}\n')
        self.assertTrue(planning.agree(mine["reach"], 0.5004882, False))
        self.assertFalse(planning.agree(mine["reach"], 0.50048, False))
        self.assertTrue(planning.agree(mine["cost_rmin"], math.inf, True))

    def test_tables_of_spot(self):
        self.assertEqual(omega.table_of(AUTCROSS)["waymark buchi"],
                         {"answers": 1, "states": 26, "edges": 91, "s": 8.1217727})
        self.assertEqual(omega.table_of(AUTCROSS.replace("output.", ""))["Spot"]["states"], 34)
        self.assertEqual(omega.failures_of(AUTCROSS), [])
        self.assertEqual(omega.failures_of(AUTCROSS.replace('"timeout",-1', '"exit code",11')), [])
        self.assertEqual(omega.failures_of(AUTCROSS.replace('"timeout",-1', '"exit code",30')),
                         ["waymark buchi: exit code 30"])


class Formulas(unittest.TestCase):
    def test_what_is_shown_is_parsed(self):
        for text in formulas.random_formulas(200, 1, True):
            self.assertEqual(formulas.show(formulas.parse(text)), text)

    def test_precedence(self):
        self.assertEqual(formulas.parse("!a U b & c -> X[!] d"),
                         ("->", ("&", ("U", ("!", ("a",)), ("b",)), ("c",)), ("X[!]", ("d",))))

    def test_a_seed_gives_the_same_formulas(self):
        self.assertEqual(formulas.random_formulas(5, 7, True), formulas.random_formulas(5, 7, True))
        self.assertNotEqual(formulas.random_formulas(5, 7, True), formulas.random_formulas(5, 8, True))

    def test_lydia_has_no_weak_until(self):
        self.assertEqual(formulas.for_lydia(formulas.parse("a W 1")), "((true) R ((a) | (true)))")


def holds(formula, word, i=0):
    """The definition, on the suffix of the word that begins at i."""
    operator, *operands = formula

    def at(k, j):
        return holds(operands[k], word, j)

    rest = range(i, len(word))
    if not operands:
        return operator == "1" or operator in word[i]
    return {
        "!": lambda: not at(0, i), "&": lambda: at(0, i) and at(1, i), "|": lambda: at(0, i) or at(1, i),
        "->": lambda: not at(0, i) or at(1, i), "<->": lambda: at(0, i) == at(1, i),
        "X[!]": lambda: i + 1 < len(word) and at(0, i + 1), "X": lambda: i + 1 == len(word) or at(0, i + 1),
        "F": lambda: any(at(0, j) for j in rest), "G": lambda: all(at(0, j) for j in rest),
        "U": lambda: any(at(1, j) and all(at(0, k) for k in range(i, j)) for j in rest),
        "M": lambda: any(at(0, j) and all(at(1, k) for k in range(i, j + 1)) for j in rest),
        "R": lambda: all(at(1, j) or any(at(0, k) for k in range(i, j)) for j in rest),
        "W": lambda: all(at(0, j) or any(at(1, k) for k in range(i, j + 1)) for j in rest),
    }[operator]()


@unittest.skipUnless(run.shutil.which("mona"), "mona is not installed")
class TranslationForMona(unittest.TestCase):
    def test_each_operator_means_what_the_definition_says(self):
        alphabet = words.letters({"a", "b"})
        texts = [f"{op}(a)" for op in formulas.UNARY] + [f"(a) {op} (b)" for level in formulas.BINARY for op in level]
        for text in texts + ["X(0)", "X[!](1)", "G((a) -> (X[!](b)))"]:
            formula, automaton = formulas.parse(text), finite.mona(text, 8).automaton
            for length in (1, 2, 3):
                for word in itertools.product(alphabet, repeat=length):
                    state, accepts = automaton.initial, False
                    for letter in word:
                        state, accepts = automaton.step(state, letter)
                    self.assertEqual(accepts, holds(formula, word), f"{text} on {words.show_word(word)}")


if __name__ == "__main__":
    unittest.main()
