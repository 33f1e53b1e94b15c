"""One HTML page about a home: its plan with rooms to click, a 3D view of storeys and rooms, verdicts, pictures."""

from .data import HomePage as HomePage
from .page import home_report as home_report
from .page import write_home_report as write_home_report

__all__ = ["HomePage", "home_report", "write_home_report"]
