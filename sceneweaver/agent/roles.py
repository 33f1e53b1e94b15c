"""Who does what in a run: the rules that need no model, or a model."""

from __future__ import annotations

from typing import Literal, Self

from pydantic import Field

from sceneweaver.scene import InputError
from sceneweaver.scene.base import FrozenModel

MOST_SAMPLES = 16


class Roles(FrozenModel):
    """Who plans, reads the request and grades; ``samples`` is how often a critic by vision looks at a scene.

    Examples:
        >>> from sceneweaver.agent.roles import Roles
        >>> Roles.of("llm"), Roles.of("rules").by_model
        (Roles(planner='llm', reader='llm', critic='vlm', samples=1), False)
    """

    planner: Literal["rules", "llm"] = "rules"
    reader: Literal["rules", "llm"] = "rules"
    critic: Literal["symbolic", "vlm"] = "symbolic"
    samples: int = Field(default=1, ge=1, le=MOST_SAMPLES)

    @classmethod
    def of(cls, planner: str, reader: str | None = None, critic: str | None = None, samples: int = 1) -> Self:
        """The roles as arguments say them; a model that plans reads and looks as well unless told otherwise.

        Raises:
            InputError: for a word that is no role, or a number of samples out of range.
        """
        with_model = planner == "llm"
        given = {
            "planner": planner,
            "reader": reader or ("llm" if with_model else "rules"),
            "critic": critic or ("vlm" if with_model else "symbolic"),
        }
        for name, known in KNOWN.items():
            if given[name] not in known:
                raise InputError(f"{name}: '{given[name]}' is unknown; use {' or '.join(known)}")
        if not 1 <= samples <= MOST_SAMPLES:
            raise InputError(f"samples: {samples} is not between 1 and {MOST_SAMPLES}")
        return cls.model_validate({**given, "samples": samples})

    @property
    def by_model(self) -> bool:
        """Whether a model has anything to do."""
        return self.planner == "llm" or self.reader == "llm" or self.critic == "vlm"


KNOWN = {"planner": ("rules", "llm"), "reader": ("rules", "llm"), "critic": ("symbolic", "vlm")}
"""Words for who does it."""
