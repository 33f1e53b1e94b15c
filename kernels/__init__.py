"""Warp code: the compiled problem's tables and everything that runs on the device."""

import os

import warp as wp

# Warp greets on first use; a library stays silent unless asked.
if not os.environ.get("SCENEWEAVER_DEBUG"):
    wp.config.quiet = True
