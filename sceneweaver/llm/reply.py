"""What goes to a model and what comes back."""

from __future__ import annotations

from dataclasses import dataclass

from pydantic import BaseModel, ConfigDict


class Reply(BaseModel):
    """Base of all structured answers: fields that are not asked for are an error, which the model is told, and so are
    numbers that are not finite."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


@dataclass(frozen=True)
class Picture:
    """A picture for a model to look at.

    Attributes:
        png: the file's bytes.
        title: what it shows, one line.
    """

    png: bytes
    title: str = ""
