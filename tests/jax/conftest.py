"""These tests take a CPU for their problems, and so JAX has to, on a machine with a GPU as well."""

import os

os.environ["JAX_PLATFORMS"] = "cpu"
