"""Layouts by the million: rooms as programs, their valid layouts as rows of Parquet."""

from .block import join, write_programs
from .pack import pack
from .tables import load_layout, load_program

__all__ = ["join", "load_layout", "load_program", "pack", "write_programs"]
