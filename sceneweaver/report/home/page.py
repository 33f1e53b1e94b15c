"""The page of a home as one file: it opens without a network, and only its own scripts can run in it."""

from __future__ import annotations

import os

import markupsafe

from sceneweaver.io import write_atomic

from ..page import rendered
from . import tables
from .data import HomePage
from .view import pack_home


def write_home_report(path: str | os.PathLike[str], page: HomePage) -> None:
    """Write the page under a temporary name and rename it; InputError when that cannot be done.

    Examples:
        >>> import tempfile
        >>> import sceneweaver as sw
        >>> from sceneweaver.render.home import report_parts
        >>> from sceneweaver.report.home import HomePage, write_home_report
        >>> home = sw.Home.example("flat")
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     write_home_report(f"{folder}/report.html", HomePage(home, **report_parts(home)))
    """
    write_atomic(path, home_report(page))


def home_report(page: HomePage) -> str:
    """The page's text.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.report.home import HomePage, home_report
        >>> home_report(HomePage(sw.Home.example("flat")))[:15]
        '<!doctype html>'
    """
    home, metrics = page.home, page.metrics
    titles = tables.room_titles(home)
    packed = pack_home(page, titles)
    rooms = tables.room_rows(page, titles)
    design = metrics.get("design") or {}
    warnings = [*map(str, metrics.get("warnings") or ()), *packed.warnings]
    apart = {room.id: [name for name, shown in page.shows.items() if shown == room.id] for room in home.rooms}
    of_rooms = {name for names in apart.values() for name in names}
    storeys = [storey for storey in home.storeys if home.rooms_of(storey.id)]
    return rendered(
        "home.html",
        packed.data,
        packed.meshes,
        style="home.css",
        page=page,
        home=home,
        title=page.title or home.prompt or home.id,
        verdict=tables.verdict(metrics),
        rooms=rooms,
        clear=sum(room.area for room in rooms if not room.outdoor),
        things=sum(room.objects or 0 for room in rooms),
        storeys=[(s.id, markupsafe.Markup(page.plans.get(s.id, ""))) for s in storeys],
        scopes=packed.data["scopes"],
        still=next((p for name, p in page.pictures.items() if name.startswith("overview")), None),
        checked=bool(metrics),
        plan=metrics.get("plan") or {},
        plan_rows=tables.plan_rows(metrics, titles),
        home_faults=tables.home_faults(metrics),
        measures=tables.measures(metrics),
        unmet=list(map(str, design.get("unmet") or ())),
        asked=tables.demand_rows(design),
        aligned=design.get("alignment"),
        remarks=list(map(str, design.get("remarks") or ())),
        designed=bool(design),
        notes=list(map(str, design.get("notes") or ())),
        undone=list(map(str, design.get("undone") or ())),
        warnings=list(dict.fromkeys(warnings)),
        apart=apart,
        captions=page.captions,
        pictures=[(n, page.captions.get(n, n.replace("_", " ")), p) for n, p in _loose(page, of_rooms)],
    )


def _loose(page: HomePage, of_rooms: set[str]) -> list:
    """The pictures that belong to no room; plans are there as drawings."""
    return [(n, p) for n, p in page.pictures.items() if n not in of_rooms and not (page.plans and n[:5] == "plan_")]
