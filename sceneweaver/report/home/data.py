"""What the page of a home is about."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from sceneweaver.assets import Mesh
from sceneweaver.assets.placed import Load
from sceneweaver.home import Home

if TYPE_CHECKING:
    from PIL.Image import Image


@dataclass(frozen=True)
class HomePage:
    """All that the page of a home shows.

    `sceneweaver.render.home.report_parts` makes ``plans``, ``solids``, ``hidden``, ``captions`` and ``shows``.

    Attributes:
        home: The home.
        metrics: In the form of a home's metrics.json: the judge's report with that of the plan under ``plan``, and
            what a design says of itself under ``design``. Empty: nobody checked.
        plans: The plan of each storey as SVG; links to ``#room-<id>`` lead to the rooms' sections.
        solids: Of each storey what stands still of the building, for the 3D view: (kind, mesh), floor or wall.
        hidden: Of each room the ids of the objects that its walls are cut too low for.
        pictures: By name.
        captions: What each of them shows.
        shows: The room that a picture is of, by the picture's name: it stands in that room's section.
        load: Brings assets by id; None is the library of this user.
        title: Of the page; empty: the request, or the name of the home.
        links: For rooms by id, a page of their own, relative to this one.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.report.home import HomePage
        >>> HomePage(sw.Home.example("flat")).pictures
        {}
    """

    home: Home
    metrics: Mapping[str, Any] = field(default_factory=dict)
    plans: Mapping[str, str] = field(default_factory=dict)
    solids: Mapping[str, Sequence[tuple[str, Mesh]]] = field(default_factory=dict)
    hidden: Mapping[str, Collection[str]] = field(default_factory=dict)
    pictures: Mapping[str, Image] = field(default_factory=dict)
    captions: Mapping[str, str] = field(default_factory=dict)
    shows: Mapping[str, str] = field(default_factory=dict)
    load: Load | None = None
    title: str = ""
    links: Mapping[str, str] = field(default_factory=dict)
