"""MuJoCo, loaded where it is needed, with its warnings in the log of Python.

By itself it appends each of them to a file MUJOCO_LOG.TXT in the working folder, which may be anybody's.
"""

from __future__ import annotations

import logging
from functools import cache
from importlib import import_module
from typing import Any

log = logging.getLogger(__name__)


@cache
def load_mujoco() -> Any:
    """The module ``mujoco``; its types are not to be seen from outside. A handler of warnings that is set stays.

    Raises:
        ImportError: MuJoCo is not installed.
    """
    mujoco: Any = import_module("mujoco")
    if mujoco.get_mju_user_warning() is None:
        mujoco.set_mju_user_warning(lambda text: log.info("MuJoCo: %s", text))
    return mujoco
