"""Warp code: the compiled problem's tables and everything that runs on the device."""

import os

import warp as wp

# Warp reports its start, missing drivers and every compilation; a library stays silent unless asked.
if not os.environ.get("SCENEWEAVER_DEBUG"):
    wp.config.log_level = wp.LOG_ERROR
