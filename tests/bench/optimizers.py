"""Optimisers to try the harness with."""

from __future__ import annotations

import os
import time

import numpy as np

from sceneweaver.layout import Problem


class Momentum:
    """Gradient descent with momentum, as docs/research.md has it."""

    steps: int | None = 20

    def init(self, problem: Problem, poses, key: int):
        x = poses.numpy()
        return problem, x, np.zeros_like(x), x

    def step(self, state):
        problem, x, speed, given = state
        _, gradient = problem.energy_and_grad(x)
        speed = 0.9 * speed - 0.01 * gradient * problem.free[problem.scene_of(len(x))]
        return problem, problem.carry(x + speed, like=given), speed, given

    def best(self, state):
        return state[1]


class Endless(Momentum):
    """Goes on until somebody ends it."""

    steps = None


class Slow(Momentum):
    """Takes its time, and more of it when it is looked at."""

    steps = 3

    def step(self, state):
        time.sleep(0.02)
        return super().step(state)

    def best(self, state):
        time.sleep(0.3)
        return super().best(state)


class Naps(Momentum):
    """Sleeps a tenth of a second in each step."""

    steps = None

    def step(self, state):
        time.sleep(0.1)
        return state


class NapsThenFails(Naps):
    """Breaks down at its fourth step."""

    def init(self, problem, poses, key):
        self.taken = 0
        return super().init(problem, poses, key)

    def step(self, state):
        self.taken += 1
        if self.taken > 3:
            raise ZeroDivisionError
        return super().step(state)


class Counting(Momentum):
    """Says itself what it costs."""

    def init(self, problem, poses, key):
        self.taken = 0
        return super().init(problem, poses, key)

    def step(self, state):
        self.taken += 1
        return super().step(state)

    def counts(self, state):
        return 7 * self.taken, 100 * self.taken


class Failing(Momentum):
    """Breaks down at its fourth step."""

    def init(self, problem, poses, key):
        self.taken = 0
        return super().init(problem, poses, key)

    def step(self, state):
        self.taken += 1
        if self.taken > 3:
            raise ZeroDivisionError("one\nover nothing")
        return super().step(state)


class Misshapen(Momentum):
    """Gives one layout too few."""

    def best(self, state):
        return state[1][1:]


class Hanging(Momentum):
    """Does not come back."""

    def step(self, state):
        time.sleep(60.0)
        return state


class Busy(Momentum):
    """Does not come back, and works all the time."""

    def step(self, state):
        while True:
            pass


class Crashing(Momentum):
    """Takes its process along."""

    def step(self, state):
        os._exit(7)


class Solved(Momentum):
    """Jumps to the poses of the scene."""

    steps = 2

    def step(self, state):
        problem, x, speed, given = state
        problem.energy(x)
        return problem, np.repeat(problem.home, len(x), axis=0), speed, given


class SolvesOne(Endless):
    """Puts the first layout at the poses of the scene, and leaves the others."""

    def step(self, state):
        problem, x, speed, given = state
        time.sleep(0.01)
        return problem, np.concatenate([problem.home, given[1:]]), speed, given


SOME = {"a": "tests.bench.optimizers:Momentum", "b": "tests.bench.optimizers:Endless"}
