"""Maps, routes, instructions, and the product as an environment."""
import importlib.util
import unittest

import numpy as np

import waymark as wm
from waymark.gym import ProductEnv


class Routes(unittest.TestCase):
    def test_a_plan_is_certified_and_its_word_satisfies_the_formula(self):
        phi = wm.parse("F chair & G !blue")
        route = wm.plan(phi, "grid", (1, 9, 0))
        self.assertTrue(route)
        self.assertEqual(route.certified_by, "definition")
        self.assertTrue(phi.holds(route.word))
        self.assertEqual(route.poses.shape, (len(route) + 1, 3))
        self.assertEqual(route.cost, len(route.actions))
        for here, action, there in zip(route.poses, route.actions, route.poses[1:]):
            self.assertEqual(route.map.successor(tuple(here), action), tuple(there))

    def test_formula_and_automaton_have_routes_of_one_cost(self):
        route = wm.plan(wm.translate("F sofa"), "grid", (1, 9, 0))
        self.assertEqual(route.certified_by, "automaton")
        self.assertEqual(route.cost, wm.plan("F sofa", "grid", (1, 9, 0)).cost)

    def test_no_route_is_a_value_with_a_reason(self):
        none = wm.plan("F chair & G !chair")
        self.assertFalse(none)
        self.assertIn("contradicts itself", none.reason)

    def test_a_lasso_goes_on_for_ever(self):
        lasso = wm.plan("G F chair & G F sofa", "grid", (1, 9, 0), semantics="infinite", order="cycle")
        self.assertTrue(lasso.is_lasso)
        self.assertEqual(lasso.prefix[-1].tolist(), lasso.cycle[0].tolist())
        self.assertEqual(lasso.cycle[0].tolist(), lasso.cycle[-1].tolist())

    def test_a_walk_is_followed_and_read_back(self):
        walk = wm.follow(wm.load_map("grid"), "1,9,0 FORWARD LEFT")
        self.assertEqual(walk.actions, ["FORWARD", "LEFT"])
        self.assertEqual(walk.certified_by, "")
        with self.assertRaises(wm.FormatError):
            wm.follow(wm.load_map("grid"), "1,9,0 UP")

    def test_maps_tell_what_they_know(self):
        grid = wm.load_map("grid")
        self.assertEqual(grid.poses.shape[1], 3)
        self.assertIn("chair", grid.propositions)
        self.assertTrue(all(len(place) == 2 for place in grid.places.values()))
        self.assertIsInstance(grid.label((1, 9, 0)), frozenset)
        with self.assertRaisesRegex(wm.FormatError, "barstool"):
            wm.plan("F barstol", grid)
        with self.assertRaises(wm.FormatError):
            wm.load_map("nowhere")

    def test_an_instruction_is_read_and_planned(self):
        answer = wm.run("walk to the easel", "grid", (1, 9, 0))
        self.assertTrue(answer.formula.holds(answer.route.word))
        self.assertIn("easel", answer.understood)
        self.assertAlmostEqual(sum(r.probability for r in wm.ground("walk to the easel", top=1000).readings), 1, 3)
        self.assertIn("<svg", answer._repr_svg_())
        with self.assertRaises(wm.NotUnderstood) as caught:
            wm.run("xyzzy flurb")
        self.assertEqual(caught.exception.words, ["xyzzy", "flurb"])

    def test_an_ongoing_task_has_a_lasso(self):
        answer = wm.run("keep coming back to the lamp", "grid", (1, 9, 0))
        self.assertEqual(answer.semantics, "infinite")
        self.assertTrue(answer.route.is_lasso)

    def test_pictures_of_maps_and_routes_are_svg(self):
        for shown in (wm.load_map("l"), wm.plan("F chair")):
            self.assertIn("<svg", shown._repr_svg_())


class Environments(unittest.TestCase):
    def test_following_the_plan_earns_the_reward_at_its_end(self):
        phi = "F easel & G !blue"
        route = wm.plan(phi, "grid", (1, 9, 0))
        env = ProductEnv(phi, "grid", (1, 9, 0))
        env.reset(seed=1)
        rewards = []
        for action in route.actions:
            _, reward, terminated, truncated, info = env.step(env.action_names.index(action))
            rewards.append(reward)
        self.assertEqual(rewards, [0.0] * (len(route) - 1) + [1.0])
        self.assertTrue(terminated)
        self.assertEqual(info["pose"], tuple(route.poses[-1]))

    def test_rewards_of_random_episodes_are_verdicts_of_the_definition(self):
        phi = wm.parse("F easel & G !blue")
        env = ProductEnv(phi, "grid", (1, 9, 0), horizon=60)
        for seed in range(30):
            _, info = env.reset(seed=seed)
            word, terminated, truncated = [env.map.label(info["pose"])], False, False
            while not (terminated or truncated):
                action = env.sample()
                _, reward, terminated, truncated, info = env.step(action)
                word.append(env.map.letter(info["pose"], env.action_names[action]))
            self.assertEqual(reward == 1, phi.holds(word), word)

    def test_masked_actions_change_nothing(self):
        env = ProductEnv("F easel", "grid", (1, 9, 180))
        env.reset(seed=1)
        while env.action_mask()[0]:
            env.step(0)
        before = env.product.describe(env._state)
        self.assertEqual(env.step(0)[1], 0.0)
        self.assertEqual(env.product.describe(env._state), before)
        self.assertEqual(env.action_mask().dtype, np.int8)

    def test_jumps_of_a_limit_deterministic_automaton_are_actions(self):
        env = ProductEnv("F G easel | F G chair", "grid", (1, 9, 0), semantics="infinite", slip=(0.1, 0.1, 0.0))
        _, info = env.reset(seed=3)
        self.assertEqual(env.action_names[3], "jump 0")
        self.assertEqual(info["action_mask"][3], 1)
        pose = info["pose"]
        _, reward, terminated, _, info = env.step(3)
        self.assertEqual((reward, terminated, info["pose"]), (0.0, False, pose))
        self.assertEqual(info["action_mask"][3], 0)

    def test_the_same_seed_gives_the_same_episode(self):
        def episode(seed):
            env = ProductEnv("F sofa", "jelly", slip=(0.2, 0.2, 0.1), slip_turn=(0.1, 0.1))
            env.reset(seed=seed)
            return [env.step(env.sample())[0] for _ in range(5)]
        self.assertEqual(episode(4), episode(4))

    def test_automata_whose_choices_may_be_unsound_are_refused(self):
        with self.assertRaises(TypeError):
            ProductEnv(wm.translate("G F easel", "tgba"))
        with self.assertRaisesRegex(wm.FormatError, "nowhere"):
            ProductEnv("F nowhere")

    @unittest.skipUnless(importlib.util.find_spec("gymnasium"), "SKIPPED: the package gymnasium is not installed")
    def test_check_env_of_gymnasium_passes(self):
        from gymnasium.utils.env_checker import check_env
        check_env(ProductEnv("F easel & G !blue", "grid", (1, 9, 0)), skip_render_check=True)


if __name__ == "__main__":
    unittest.main()
