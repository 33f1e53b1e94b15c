"""One HTML page about a scene: an interactive 3D view, pictures, numbers and how it came about."""

from .data import RankedCall as RankedCall
from .data import ReportData as ReportData
from .data import StepRow as StepRow
from .data import ThoughtRow as ThoughtRow
from .page import report_html as report_html
from .page import view_html as view_html
from .page import write_report as write_report

__all__ = ["RankedCall", "ReportData", "StepRow", "ThoughtRow", "report_html", "view_html", "write_report"]
