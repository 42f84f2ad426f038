"""Formulas, words, automata and monitors, each engine against the definition."""
import itertools
import unittest

import waymark as wm

LETTERS = [frozenset(), frozenset("a"), frozenset("b"), frozenset("ab")]


def finite_words(longest):
    for length in range(1, longest + 1):
        yield from itertools.product(LETTERS, repeat=length)


class Formulas(unittest.TestCase):
    def test_equal_formulas_are_equal_whatever_text_they_came_from(self):
        one, other = wm.parse("a & b") | wm.parse("c"), wm.parse("c | (b & a)")
        self.assertEqual(one, other)
        self.assertEqual(hash(one), hash(other))
        self.assertNotEqual(one, wm.parse("c | a"))

    def test_text_in_every_style_is_read_back(self):
        phi = wm.parse("G(a -> X (b U c))")
        self.assertEqual(wm.parse(str(phi)), phi)
        self.assertEqual(wm.parse(phi.text("lbt"), notation="lbt"), phi)
        self.assertEqual(wm.parse(phi.text("postfix"), notation="postfix"), phi)
        self.assertEqual(wm.parse(phi.text("unicode")), phi)
        self.assertTrue(phi._repr_latex_().startswith("$"))

    def test_operators_build_what_the_text_says(self):
        a, b = wm.parse("a"), wm.parse("b")
        for built, text in [(a & b, "a & b"), (a | b, "a | b"), (a ^ b, "a ^ b"), (a >> b, "a -> b"), (~a, "!a"),
                            (a.iff(b), "a <-> b"), (a.until(b), "a U b"), (a.release(b), "a R b"),
                            (a.weak_until(b), "a W b"), (a.next(), "X a"), (a.weak_next(), "N a"),
                            (a.eventually(), "F a"), (a.always(), "G a")]:
            self.assertEqual(built, wm.parse(text))

    def test_progression_agrees_with_the_definition(self):
        for phi in wm.random_formulas(30, seed=5, size=7, propositions=["a", "b"]):
            for word in finite_words(3):
                rest = phi
                for letter in word:
                    rest = rest.progress(letter)
                self.assertEqual(rest.accepts_empty(), phi.holds(word), (phi, word))

    def test_simplified_formulas_hold_on_the_same_words(self):
        for phi in wm.random_formulas(30, seed=6, size=8, propositions=["a", "b"]):
            simpler = wm.simplify(phi)
            for word in finite_words(3):
                self.assertEqual(simpler.holds(word), phi.holds(word), (phi, word))

    def test_truth_by_position_is_the_truth_of_every_rest(self):
        for phi in wm.random_formulas(20, seed=7, size=8, propositions=["a", "b"]):
            word = [LETTERS[i % 4] for i in (1, 2, 0, 3, 1)]
            truth = phi.truth(word)
            self.assertEqual(truth.dtype, bool)
            self.assertEqual(truth.tolist(), [phi.holds(word[i:]) for i in range(len(word))])

    def test_random_formulas_are_the_same_for_one_seed(self):
        self.assertEqual(wm.random_formulas(5, seed=3), wm.random_formulas(5, seed=3))
        self.assertNotEqual(wm.random_formulas(5, seed=3), wm.random_formulas(5, seed=4))

    def test_words_are_read_from_text(self):
        self.assertTrue(wm.accepts("G F a", "{b}; ({}; {a})w"))
        self.assertFalse(wm.accepts("F G a", [{"b"}], cycle=[set(), {"a"}]))
        self.assertTrue(wm.accepts("a & X b", "a; b"))

    def test_formulas_in_english(self):
        self.assertEqual(wm.parse("F chair").english(map=wm.load_map("grid")), "go to the chair.")

    def test_errors_point_into_the_text(self):
        with self.assertRaises(wm.ParseError) as caught:
            wm.parse("F (a U ")
        self.assertEqual((caught.exception.line, caught.exception.column), (1, 8))
        self.assertIn("expected a formula after 'U'", str(caught.exception))
        self.assertIsInstance(caught.exception, ValueError)
        with self.assertRaises(wm.ParseError):
            wm.accepts("a", "a; (b")
        with self.assertRaisesRegex(wm.ParseError, "chair"):
            wm.parse("chiar", propositions=["chair"])


class Automata(unittest.TestCase):
    def test_dfas_accept_what_the_definition_says(self):
        for phi in wm.random_formulas(20, seed=8, size=7, propositions=["a", "b"]):
            dfa = wm.translate(phi)
            for word in finite_words(3):
                self.assertEqual(dfa.accepts(word), phi.holds(word), (phi, word))

    def test_the_table_of_a_dfa_is_its_transition_function(self):
        dfa = wm.translate("a U (b & X a)")
        self.assertEqual(dfa.table().shape, (dfa.states, 4))
        for q in range(dfa.states):
            for bits in range(4):
                letter = [p for i, p in enumerate(dfa.propositions) if bits >> i & 1]
                self.assertEqual(dfa.table()[q, bits], dfa.next(q, letter))
        self.assertEqual([bool(x) for x in dfa.accepting], [dfa.is_accepting(q) for q in range(dfa.states)])
        self.assertEqual(dfa.run("{b}; {a}")[0], dfa.initial)

    def test_every_omega_automaton_accepts_what_the_definition_says(self):
        lassos = [("{}", "{a}"), ("{a}; {b}", "{}"), ("{b}", "{a}; {b}"), ("{}", "{a, b}; {}")]
        for phi in wm.random_formulas(12, seed=9, size=7, propositions=["a", "b"], semantics="infinite"):
            for kind in ("tgba", "buchi", "parity", "rabin", "generic", "ldba"):
                automaton = wm.translate(phi, kind)
                for prefix, cycle in lassos:
                    word = f"{prefix}; ({cycle})w"
                    self.assertEqual(automaton.accepts(word), phi.holds(word), (phi, kind, word))

    def test_hoa_out_and_in_keeps_the_language(self):
        dfa = wm.from_hoa(wm.translate("a U b").hoa("a U b"))
        self.assertIsNone(dfa.difference(wm.translate("a U b")))
        omega = wm.from_hoa(wm.translate("G F a", "tgba").hoa())
        self.assertIsInstance(omega, wm.OmegaAutomaton)
        self.assertTrue(omega.accepts("({a})w"))
        with self.assertRaises(wm.FormatError):
            wm.from_hoa("HOA: v2")

    def test_products_and_differences(self):
        a, b = wm.translate("F a"), wm.translate("F b")
        self.assertIsNone((a & b).difference(wm.translate("F a & F b")))
        self.assertIsNone((a | b).difference(wm.translate("F a | F b")))
        self.assertIsNone((a - b).difference(wm.translate("F a & !F b")))
        word, first = a.difference(b)
        self.assertEqual(first, a.accepts(word))
        self.assertNotEqual(first, b.accepts(word))

    def test_limits_and_wrong_names_are_told_apart(self):
        with self.assertRaises(wm.LimitError):
            wm.translate("F(a & X X X X X b) & F(c & X X X X X d)", limit_states=3)
        with self.assertRaises(ValueError):
            wm.translate("a", "nba")
        with self.assertRaises(IndexError):
            wm.translate("a").next(99, "a")

    def test_pictures_are_svg(self):
        for shown in (wm.parse("a U b"), wm.translate("a U b"), wm.translate("G F a", "tgba"),
                      wm.translate("F G a", "ldba")):
            self.assertIn("<svg", shown._repr_svg_())


class Monitors(unittest.TestCase):
    def test_verdicts_over_infinite_words(self):
        monitor = wm.monitor("G(a -> F b) & G !c")
        self.assertEqual(monitor.read("a"), "open")
        self.assertEqual(str(monitor.remains), "F b & G(a -> F b) & G !c")
        self.assertEqual(monitor.read("c"), "false")
        monitor.reset()
        self.assertEqual(monitor.verdict, "open")

    def test_conjuncts_are_monitored_apart(self):
        phi = " & ".join(f"G(a{i} -> F b{i})" for i in range(200))
        for semantics, last in (("infinite", "open"), ("finite", "open")):
            monitor = wm.monitor(phi, semantics)
            for i in range(300):
                self.assertEqual(monitor.read({f"a{i % 200}"}), last)
            if semantics == "finite":
                self.assertFalse(monitor.holds_now)
                monitor.read({f"b{i}" for i in range(200)})
                self.assertTrue(monitor.holds_now)
        monitor = wm.monitor(phi + " & G !c")
        monitor.read({"a1"})
        self.assertEqual(monitor.read({"c"}), "false")
        together = wm.monitor("G a & F !a")
        self.assertEqual(together.verdict, "false")

    def test_verdicts_over_finite_words_agree_with_the_definition(self):
        for phi in wm.random_formulas(15, seed=10, size=6, propositions=["a", "b"]):
            for word in finite_words(2):
                monitor = wm.monitor(phi, "finite")
                for letter in word:
                    monitor.read(letter)
                self.assertEqual(monitor.holds_now, phi.holds(word))
                if monitor.verdict != "open":
                    for more in LETTERS:
                        self.assertEqual(phi.holds([*word, more]), monitor.verdict == "true", (phi, word))

    def test_explanations_have_a_word_of_either_kind(self):
        told = wm.explain("a U b")
        self.assertTrue(wm.accepts("a U b", told.satisfying))
        self.assertFalse(wm.accepts("a U b", told.violating))
        prefix, cycle = wm.explain("G F a", "infinite").violating
        self.assertFalse(wm.accepts("G F a", prefix, cycle))
        self.assertIsNone(wm.explain("a | !a").violating)


if __name__ == "__main__":
    unittest.main()
