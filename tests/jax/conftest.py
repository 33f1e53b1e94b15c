"""JAX takes the device of the tests' problems: a CPU, on a machine with a GPU as well, unless they are told another."""

import os

if os.environ.get("SCENEWEAVER_TEST_DEVICE", "cpu") == "cpu":
    os.environ["JAX_PLATFORMS"] = "cpu"
