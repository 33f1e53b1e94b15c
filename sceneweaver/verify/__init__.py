"""The independent judge of scenes: float64, shapely and manifold3d; it shares no arithmetic with the engine."""

from sceneweaver.verify.check import check as check
from sceneweaver.verify.measure import Judgement as Judgement
from sceneweaver.verify.measure import Measurement as Measurement
from sceneweaver.verify.meshes import MeshSet as MeshSet
from sceneweaver.verify.relations import Case as Case
from sceneweaver.verify.relations import register_judge as register_judge
from sceneweaver.verify.report import RelationRef as RelationRef
from sceneweaver.verify.report import RelationTally as RelationTally
from sceneweaver.verify.report import Report as Report
from sceneweaver.verify.report import Tally as Tally
from sceneweaver.verify.report import Violation as Violation

__all__ = [
    "Case",
    "Judgement",
    "Measurement",
    "MeshSet",
    "RelationRef",
    "RelationTally",
    "Report",
    "Tally",
    "Violation",
    "check",
    "register_judge",
]
