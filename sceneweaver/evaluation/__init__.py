"""Scenes of any system judged alike, and systems side by side.

Every figure has its definition and where it comes from in `METRICS`. What a file does not say is never a zero: the
figure then has no value, but the reason.
"""

from .candidate import Candidate as Candidate
from .candidate import Reading as Reading
from .candidate import candidates as candidates
from .compare import Comparison as Comparison
from .compare import compare as compare
from .compare import evaluate as evaluate
from .files import write_comparison as write_comparison
from .judge import SceneRow as SceneRow
from .judge import judge_scene as judge_scene
from .metrics import METRICS as METRICS
from .metrics import Metric as Metric
from .requested import Requests as Requests
from .summary import Evaluation as Evaluation
from .summary import Figure as Figure

__all__ = [
    "METRICS",
    "Candidate",
    "Comparison",
    "Evaluation",
    "Figure",
    "Metric",
    "Reading",
    "Requests",
    "SceneRow",
    "candidates",
    "compare",
    "evaluate",
    "judge_scene",
    "write_comparison",
]
