"""The process in which Drake runs: it may abort on geometry that it cannot tell the gradient of.

Imported inside functions only: it needs drake.
"""

from __future__ import annotations

import time
from multiprocessing.connection import Connection

import numpy as np
from pydrake.multibody.inverse_kinematics import InverseKinematics
from pydrake.solvers import SnoptSolver, SolverOptions

from benchmarks.rivals.drake_world import World
from sceneweaver.scene import Scene

ARM = 0.5  # [m] what a radian of yaw weighs against metres
APART = 0.0005  # [m] least distance that is asked for: where boxes just touch, Drake may find no gradient and abort
INFLUENCE = 0.02  # [m] beyond it at which the constraint begins to look at a pair
MAJOR, MINOR = 200, 20_000  # most iterations of SNOPT, and of the quadratic programs inside
TOUCH = 0.001  # [m] that the judge lets things sink into each other


class Late(Exception):
    """The time limit has passed."""


def nearest(world: World, start: np.ndarray, seconds: float) -> tuple[np.ndarray, bool]:
    """The nearest positions [3 n] (x, y, yaw of floor objects) to a start, and whether nothing overlaps there."""
    deadline = time.monotonic() + seconds
    kinematics = InverseKinematics(world.plant, world.context, with_joint_limits=False)
    kinematics.AddMinimumDistanceLowerBoundConstraint(APART, INFLUENCE)
    program, q = kinematics.get_mutable_prog(), kinematics.q()
    program.AddQuadraticErrorCost(np.diag(np.tile((1.0, 1.0, ARM**2), len(start) // 3)), start, q)

    def look(_: np.ndarray) -> None:
        if time.monotonic() > deadline:
            raise Late

    program.AddVisualizationCallback(look, q)
    options = SolverOptions()
    options.SetOption(SnoptSolver.id(), "Major iterations limit", MAJOR)
    options.SetOption(SnoptSolver.id(), "Iterations limit", MINOR)
    try:
        found = SnoptSolver().Solve(program, start, options).GetSolution(q)
    except RuntimeError as error:  # what is raised in an evaluation comes back as this, with its name in the text
        if Late.__name__ not in str(error):
            raise
        found = start
    return (found, world.depth(found) <= TOUCH) if np.isfinite(found).all() else (start, False)


def serve(connection: Connection) -> None:
    """Build a world for each scene that comes as text; answer each (start, seconds) for the last one; until it ends."""
    world = None
    while True:
        try:
            task = connection.recv()
        except EOFError:
            return
        if isinstance(task, str):
            world = World(Scene.loads(task))
            connection.send(True)
        elif world is not None:
            connection.send(nearest(world, *task))
