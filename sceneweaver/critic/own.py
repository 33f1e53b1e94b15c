"""Checks of the user's own, which the critic carries out after its own ones."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from sceneweaver.scene import InputError, Scene

from .grade import Finding
from .model import CRITERIA, Fault
from .survey import Survey

Check = Callable[[Scene], Iterable[Fault]]

CHECKS: dict[str, Check] = {}
"""Checks by name, in the order of their definition."""


def define_check(name: str, check: Check) -> None:
    """Let the critic carry out a check of your own on every scene that it grades from then on.

    Args:
        name: any text; it takes the check back (`undefine_check`).
        check: ``check(scene)`` gives a `Fault` for each thing that is wrong. Its ``points`` come off the grade of its
            ``criterion``; with a ``tool`` and its ``inputs`` the agent may mend it.

    Raises:
        InputError: the name is taken. A check that fails raises one when a scene is graded.

    Examples:
        >>> import sceneweaver as sw
        >>> def no_plants(scene):
        ...     if not any("plant" in o.category for o in scene.objects):
        ...         yield sw.Fault(criterion="realism", kind="no_plants", reason="nothing in the room is green")
        >>> sw.define_check("no plants", no_plants)
        >>> sw.undefine_check("no plants")
    """
    if name in CHECKS:
        raise InputError(f'check "{name}" is there already; choose another name')
    CHECKS[name] = check


def undefine_check(name: str) -> None:
    """Take back a check.

    Raises:
        InputError: there is none of this name.

    Examples:
        >>> import sceneweaver as sw
        >>> sw.undefine_check("no plants")
        Traceback (most recent call last):
            ...
        sceneweaver.io.errors.InputError: check "no plants" is unknown
    """
    if CHECKS.pop(name, None) is None:
        raise InputError(f'check "{name}" is unknown')


def faults(survey: Survey) -> Iterator[Finding]:
    """What the checks find in the scene."""
    for name, check in CHECKS.items():
        try:
            found = list(check(survey.scene))
        except Exception as error:
            raise InputError(f'check "{name}": {type(error).__name__}: {error}') from error
        for fault in found:
            if not isinstance(fault, Fault):
                raise InputError(f'check "{name}": gave {type(fault).__name__}, not a Fault')
            if fault.criterion not in CRITERIA:
                raise InputError(f'check "{name}": criterion "{fault.criterion}" is none of {", ".join(CRITERIA)}')
            yield Finding(fault, fault.lid)
