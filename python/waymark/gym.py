"""The product of a map and a task as an environment in the style of Gymnasium.

    env = waymark.gym.ProductEnv("F easel & G !blue", map="grid", start=(1, 9, 0))
    observation, info = env.reset(seed=1)
    observation, reward, terminated, truncated, info = env.step(env.sample())

Where the package gymnasium can be imported, ProductEnv is a gymnasium.Env and its spaces are those of gymnasium; else
it has the same methods, and spaces with the same attributes.
"""
from __future__ import annotations

import numpy as np

from . import Automaton, Dfa, Formula, LimitDeterministic, Map, Product, Start, _start, load_map, parse, translate

try:
    import gymnasium
    from gymnasium.spaces import Discrete
    _Env = gymnasium.Env
except ImportError:
    _Env = object

    class Discrete:  # type: ignore[no-redef]
        """The numbers 0 … n − 1."""

        def __init__(self, n: int):
            self.n = n

        def contains(self, x) -> bool:
            return isinstance(x, (int, np.integer)) and 0 <= x < self.n


class ProductEnv(_Env):
    """Episodes in the product of a map and the automaton of a task.

    An observation is the number of a state of the product: of a pair of pose and task. Actions are FORWARD, LEFT and
    RIGHT, then the jumps of a limit-deterministic automaton; `info["action_mask"]` says which can be taken. A finite
    task ends with reward 1 where the word may end. An ongoing task (`semantics="infinite"`) gives reward 1 for every
    accepting edge, and ends without reward where nothing can be accepted any more. An action that is masked changes
    nothing and gives no reward. After `horizon` actions an episode is truncated.

    slip: chances of FORWARD to go left, right and back; slip_turn: of a turn to fail and to go too far.
    """

    metadata = {"render_modes": ["ansi"]}

    def __init__(self, task: str | Formula | Automaton, map: str | Map = "grid", start: Start = None, *,
                 semantics: str = "finite", horizon: int = 500, slip=(0.0, 0.0, 0.0), slip_turn=(0.0, 0.0),
                 render_mode: str | None = None):
        self.map = load_map(map)
        if isinstance(task, (str, Formula)):
            if semantics not in ("finite", "infinite"):
                raise ValueError(f"semantics is 'finite' or 'infinite', not {semantics!r}")
            task = translate(parse(task), "dfa" if semantics == "finite" else "ldba")
        if not isinstance(task, (Dfa, LimitDeterministic)):
            raise TypeError("the task is a formula, a Dfa or a LimitDeterministic automaton: the choices of any other "
                            "automaton may be unsound here")
        self.automaton = task
        self.product = Product(self.map, task, _start(start, self.map), tuple(slip), tuple(slip_turn))
        self.horizon = horizon
        self.render_mode = render_mode
        self.action_names = ["FORWARD", "LEFT", "RIGHT"] + [f"jump {i}" for i in range(self.product.actions - 3)]
        self.observation_space = Discrete(self.product.states)
        self.action_space = Discrete(self.product.actions)
        self._random = np.random.default_rng()
        self._state: int | None = None
        self._age = 0

    def reset(self, *, seed: int | None = None, options: dict | None = None):
        """Begins an episode; of several start poses each is equally likely."""
        if _Env is not object:
            super().reset(seed=seed)
        if seed is not None:
            self._random = np.random.default_rng(seed)
        starts = self.product.starts
        self._state = int(starts[self._random.integers(len(starts))])
        self._age = 0
        return self._state, self._info()

    def step(self, action):
        """(observation, reward, terminated, truncated, info)."""
        if self._state is None:
            raise RuntimeError("reset() comes before step()")
        if not 0 <= int(action) < self.product.actions:
            raise ValueError(f"there is no action {action}")
        reward, terminated = 0.0, self.product.is_over(self._state)
        if self.action_mask()[int(action)]:
            self._state, reward, terminated = self.product.step(self._state, int(action), self._random.random())
        self._age += 1
        return self._state, reward, terminated, self._age >= self.horizon, self._info()

    def action_mask(self) -> np.ndarray:
        """By action: 1 where it can be taken now."""
        return self.product.mask(self._state)

    def sample(self) -> int:
        """An action that can be taken now, each equally likely."""
        possible = np.flatnonzero(self.action_mask())
        if possible.size == 0:
            raise RuntimeError("the task is over: reset() comes next")
        return int(self._random.choice(possible))

    def render(self) -> str | None:
        """The pose and the state of the automaton as text; None unless render_mode is 'ansi'."""
        if self.render_mode != "ansi":
            return None
        (x, y, heading), q = self.product.describe(self._state)
        return f"({x}, {y}) heading {heading}, " + ("in the trap" if q is None else f"automaton state {q}")

    def close(self) -> None:
        """Nothing is held open."""

    def _info(self) -> dict:
        pose, q = self.product.describe(self._state)
        return {"action_mask": self.action_mask(), "pose": pose, "task": q}
