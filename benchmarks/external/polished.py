"""Placers with the engine's projection behind them, as methods of their own.

Fairness: the projection (`Problem.project`, with the search that takes over where it does not get on) knows everything
that the engine knows, so what these measure is how good a start the placer gives; where the plain method loses by a
constraint that it does not know, this one shows by how much. Never to be read as the placer's own merit.
"""

from __future__ import annotations

from sceneweaver.layout import StepOptimizer


def HolodeckDfs() -> StepOptimizer:
    from .holodeck_dfs import HolodeckDfs as Method

    return Method(polish=True)


def Rejection() -> StepOptimizer:
    from .rejection import Rejection as Method

    return Method(polish=True)


def LayoutVlm() -> StepOptimizer:
    from .layoutvlm import LayoutVlm as Method

    return Method(polish=True)


def ArenaRelations() -> StepOptimizer:
    from .arena_relations import ArenaRelations as Method

    return Method(polish=True)


def SequencePair() -> StepOptimizer:
    from .sequence_pair_plan import SequencePair as Method

    return Method(polish=True)


def BStarTree() -> StepOptimizer:
    from .bstar_tree import BStarTree as Method

    return Method(polish=True)
