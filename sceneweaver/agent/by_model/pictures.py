"""Pictures of a room for a model to look at: marked from above, from above a corner, and at eye level."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator

from PIL import Image

from sceneweaver.agent.deadline import NEVER, Deadline
from sceneweaver.assets import Asset
from sceneweaver.llm import Picture
from sceneweaver.scene import Scene, SceneWeaverError

SIDE, SIZE = 760, (800, 600)
"""Longest side [pixels] of the plan, and size of the other pictures."""

MOST_BYTES = 150_000
"""Largest file of a picture."""

MARKED = 24
"""Things off the floor that are marked in the top view; where there are more, those on supports are not."""

EYE_VIEWS = {"eye-corner": "eye level, from a corner", "eye-door": "eye level, from the door"}
"""Views at eye level, the first to be drawn first, with what they are titled."""

TOP = (
    "top view: grid and axes in metres, boxes with ids, arrows to the front of each; a number alone on a thing is the "
    "end of its id"
)
OVERVIEW = "the room from above a corner, the walls in the way cut off"

_TEXT = 1.25  # how much larger than in pictures for people what is written is
_COLORS = (256, 128, 64, 32)

Load = Callable[[str], Asset]


def top_picture(scene: Scene, load: Load | None = None, *, device: str = "cpu") -> Picture:
    """The annotated top view; where its meshes cannot be drawn, the plan of its outlines.

    Args:
        scene: the scene.
        load: gives the asset of an id; None: ``Library().load``.
        device: where it is drawn.
    """
    from sceneweaver.render import Quality, draw_top
    from sceneweaver.render.views import draw_marked

    try:
        image = draw_marked(scene, load, SIDE, most=MARKED, text=_TEXT, quality=Quality.draft(), device=device)
    except SceneWeaverError:
        image = draw_top(scene, width=SIZE[0])
    return Picture(packed(image), TOP)


def room_pictures(
    scene: Scene,
    load: Load | None = None,
    *,
    device: str = "cpu",
    deadline: Deadline = NEVER,
    eye_level: bool = True,
) -> tuple[Picture, ...]:
    """What a critic looks at: the top view, then the overview, then two views at eye level.

    A few seconds on a processor. Equal scenes give equal bytes on one machine. When time is up, those that are not
    drawn yet are left out; so are those that cannot be drawn. The top view is always there.
    """
    return tuple(_drawn(scene, load, device, deadline, eye_level))


def _drawn(scene: Scene, load: Load | None, device: str, deadline: Deadline, eye_level: bool) -> Iterator[Picture]:
    from sceneweaver.render import EyeLevel, Quality, draw_room

    yield top_picture(scene, load, device=device)
    try:
        if not deadline.passed:
            yield Picture(packed(draw_room(scene, load, "corner", *SIZE, Quality.draft(), device)), OVERVIEW)
        if not eye_level or deadline.passed:
            return
        room = EyeLevel(scene, load, SIZE[0] / SIZE[1], device)
        for view, title in EYE_VIEWS.items():
            if not deadline.passed:
                yield Picture(packed(room.draw(view, *SIZE, Quality.draft())), title)
    except SceneWeaverError:  # a mesh or finish that is not there: the plan has to do
        return


def packed(image: Image.Image, most: int = MOST_BYTES) -> bytes:
    """The picture as a PNG file of at most ``most`` bytes: of few colours, near to its own, and smaller if it has to
    be."""
    content = b""
    while True:
        for colors in _COLORS:
            settled = image.width * image.height // 50  # pixels that may still change their colour
            few = image.convert("RGB").quantize(
                colors, Image.Quantize.MAXCOVERAGE, kmeans=settled, dither=Image.Dither.NONE
            )
            with io.BytesIO() as file:
                few.save(file, "PNG", optimize=True)
                content = file.getvalue()
            if len(content) <= most:
                return content
        image = image.resize((max(1, image.width * 3 // 4), max(1, image.height * 3 // 4)))
