"""Devices that the optimisers are tested on: those of the kernels' tests."""

from tests.kernels.conftest import device as device
