"""Devices that the kernels are tested on."""

from __future__ import annotations

import pytest
import warp as wp

import sceneweaver.kernels  # noqa: F401  starts Warp quietly


@pytest.fixture(scope="session", params=["cpu", "cuda:0"] if wp.is_cuda_available() else ["cpu"])
def device(request) -> str:
    """The CPU always; the first GPU too where there is one."""
    return request.param
