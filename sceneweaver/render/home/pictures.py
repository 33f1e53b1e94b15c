"""All pictures of a home by name: plans, storeys without their roof, and the stops of a walk."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

from PIL import Image

from sceneweaver.assets import Asset
from sceneweaver.home import Home
from sceneweaver.io.messages import suggest
from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.scene import InputError

from ..tracing import Quality
from .overview import draw_overview, hidden_when_cut, open_storey
from .plan import draw_plan, plan_picture
from .plan_names import room_titles
from .walk import Walk, walk_order

OVERVIEW_DRAFT = Quality(windows=1, lamps=1, bounces=5, suns=3, spacing=2, levels=4, rays=4)
"""How carefully storeys are drawn for a quick look: by day there is light from all sides."""


def home_views(home: Home) -> dict[str, str]:
    """The names of the pictures of a home in the order of a report, with what each shows in words.

    ``plan_<storey>`` and ``overview_<storey>`` for each storey, ``walk_01`` ... for the stops of a walk from the
    entrance.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.render.home import home_views
        >>> list(home_views(sw.Home.example("flat")))[:3]
        ['plan_ground', 'overview_ground', 'walk_01']
    """
    storeys = [storey.id for storey in home.storeys if home.rooms_of(storey.id)]
    several = len(storeys) > 1
    found = {}
    for kind, words in (("plan", "Plan"), ("overview", "Without roof")):
        found |= {f"{kind}_{storey}": f"{words}, {storey} storey" if several else words for storey in storeys}
    walk, titles = walk_order(home), room_titles(home)
    for k, stop in enumerate(walk):
        found[f"walk_{k + 1:02d}"] = stop.caption(titles)
    return found


def home_view(home: Home, view: str) -> str:
    """The name of a picture among `home_views`, where "plan" and "overview" are those of the lowest storey.

    Raises:
        InputError: for a view that is unknown.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.render.home import home_view
        >>> home_view(sw.Home.example("flat"), "overview")
        'overview_ground'
    """
    known = home_views(home)
    short = {name.partition("_")[0]: name for name in reversed(known) if not name.startswith("walk")}
    if view not in known and view not in short:
        raise InputError(f"view: '{view}' is unknown{suggest(view, known)}")
    return short.get(view, view)


def report_parts(home: Home) -> dict[str, Any]:
    """What `sceneweaver.report.home.HomePage` takes of drawings: plans, solids, hidden, captions, shows.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.render.home import report_parts
        >>> report_parts(sw.Home.example("flat"))["shows"]["walk_01"]
        'hall'
    """
    links = {room.id: f"#room-{room.id}" for room in home.rooms}
    storeys = [storey.id for storey in home.storeys if home.rooms_of(storey.id)]
    return {
        "plans": {storey: draw_plan(home, storey, links=links) for storey in storeys},
        "solids": {storey: open_storey(home, storey) for storey in storeys},
        "hidden": {r.id: hidden_when_cut(r.scene) for r in home.rooms if r.scene is not None},
        "captions": home_views(home),
        "shows": {f"walk_{k + 1:02d}": stop.room for k, stop in enumerate(walk_order(home))},
    }


def render_home(
    home: Home,
    load: Callable[[str], Asset] | None = None,
    views: Sequence[str] | None = None,
    width: int = 1120,
    height: int = 840,
    quality: Quality | None = None,
    device: str = "cpu",
) -> dict[str, Image.Image]:
    """Pictures of a home, by name.

    Args:
        home: The home; rooms without a scene are empty.
        load: Gives the asset of an id; None: ``Library().load``.
        views: Which of `home_views`; None: all.
        width: Width of a picture in pixels; plans are drawn at 160 dots an inch.
        height: Its height.
        quality: How carefully pictures are traced; None: `Quality.draft`, some 8 seconds of one core a picture.
        device: Where they are traced: "cpu" or "cuda:0".

    Raises:
        InputError: for a view that is unknown, too few pixels, or an asset that cannot be loaded.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.render.home import render_home
        >>> list(render_home(sw.Home.example("flat"), views=["plan_ground"]))
        ['plan_ground']
    """
    return dict(home_pictures(home, load, views, width, height, quality, device))


def home_pictures(
    home: Home,
    load: Callable[[str], Asset] | None = None,
    views: Sequence[str] | None = None,
    width: int = 1120,
    height: int = 840,
    quality: Quality | None = None,
    device: str = "cpu",
) -> Iterator[tuple[str, Image.Image]]:
    """The pictures of `render_home` one by one, each as soon as it is drawn.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.render.home import home_pictures
        >>> next(home_pictures(sw.Home.example("flat")))[0]
        'plan_ground'
    """
    known = list(home_views(home))
    for view in views or ():
        if view not in known:
            raise InputError(f"view: '{view}' is unknown{suggest(view, known)}")
    if width < 16 or height < 16:
        raise InputError(f"width, height: {width} x {height} pixels are too few for a room; use at least 16 x 16")
    return _drawn(home, load, known if views is None else list(views), (width, height), quality, device)


def _drawn(
    home: Home,
    load: Callable[[str], Asset] | None,
    views: Sequence[str],
    size: tuple[int, int],
    quality: Quality | None,
    device: str,
) -> Iterator[tuple[str, Image.Image]]:
    walk = Walk(home, load, size[0] / size[1], device)
    for view in views:
        checkpoint()
        kind, _, what = view.partition("_")
        if kind == "plan":
            yield view, plan_picture(home, what)
        elif kind == "overview":
            yield view, draw_overview(home, what, load, *size, quality or OVERVIEW_DRAFT, device)
        else:
            yield view, walk.picture(int(what) - 1, *size, quality or Quality.draft())
