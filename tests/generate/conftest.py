"""What the tests of drafts share."""

from __future__ import annotations

import pytest

from sceneweaver.assets import Library
from sceneweaver.assets.sources.parametric import ParametricSource


@pytest.fixture(scope="session")
def library() -> Library:
    """Our own assets only, so that no store on this machine matters."""
    return Library(sources=[ParametricSource()])
