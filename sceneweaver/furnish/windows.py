"""Windows as high as what stands under them needs: units with a tap in kitchens, eyes of others in baths."""

from __future__ import annotations

from sceneweaver.home import Home, HomeWindow

from .kinds import kind_of

HEAD = 0.2
"""Wall [m] that stays over a window."""

LEAST = 0.5
"""Least height [m] of a window."""


def with_sills(home: Home) -> Home:
    """The home with the sills of its windows no lower than rooms of their kind have them.

    The upper edge stays where it is, as far as the window is then still one.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.furnish.windows import with_sills
        >>> [w.sill for w in with_sills(sw.Home.example("flat")).windows if w.room == "kitchen"]
        [1.32, 1.32]
    """
    windows = tuple(_raised(home, window) for window in home.windows)
    return home if windows == home.windows else home.with_changes(windows=windows)


def _raised(home: Home, window: HomeWindow) -> HomeWindow:
    kind = kind_of(home.room(window.room).type)
    if kind is None or window.sill >= kind.windows.sill[0] or kind.windows.sill[0] < 1.0:
        return window
    sill, head = kind.windows.sill[0], window.sill + window.height
    top = min(max(head, sill + kind.windows.height[0]), home.storey_of(window.room).height - HEAD)
    height = round(top - sill, 3)
    return window.model_copy(update={"sill": sill, "height": height}) if height >= LEAST else window
