"""The model of a run: what it is asked for, and who does that in its place."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

from sceneweaver.agent.planner import Planner, RulesPlanner
from sceneweaver.agent.roles import Roles
from sceneweaver.llm import ModelClient
from sceneweaver.scene import MissingDependencyError

from .planner import ModelPlanner
from .strict import StrictClient


@dataclass
class Session:
    """Who does what in one run. ``client`` is None where no model has anything to do."""

    roles: Roles
    client: ModelClient | None = None

    @classmethod
    def opened(cls, roles: Roles, model: ModelClient | None, *, strict: bool = False) -> Self:
        """A session with a model, if the roles ask for one.

        Raises:
            MissingDependencyError: when they do and there is none.
        """
        if not roles.by_model:
            return cls(roles)
        if model is None:
            raise MissingDependencyError("planner llm needs a language model, and none is set up; use planner rules")
        return cls(roles, StrictClient(model) if strict else model)

    def planner(self) -> Planner:
        """Who plans."""
        return ModelPlanner(self.client) if self.client is not None and self.roles.planner == "llm" else RulesPlanner()
