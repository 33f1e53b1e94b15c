"""What a scene is: its typed model, the relation catalogue, edits, and ``scene.json``.

A scene is immutable. Anything wrong with a file, a field or an edit raises InputError with one line that names the
field and the fix.
"""

from sceneweaver.io import InputError as InputError
from sceneweaver.io import MissingDependencyError as MissingDependencyError
from sceneweaver.io import SceneWeaverError as SceneWeaverError

from .catalogue import CATALOGUE as CATALOGUE
from .catalogue import SIDES as SIDES
from .catalogue import TUCKED as TUCKED
from .catalogue import ParamSpec as ParamSpec
from .catalogue import RelationSpec as RelationSpec
from .catalogue import register_relation as register_relation
from .catalogue import unregister_relation as unregister_relation
from .edits import EDITS as EDITS
from .edits import Add as Add
from .edits import AnyEdit as AnyEdit
from .edits import Edit as Edit
from .edits import Geometry as Geometry
from .edits import Relate as Relate
from .edits import Remove as Remove
from .edits import Rename as Rename
from .edits import Replace as Replace
from .edits import SetAttributes as SetAttributes
from .edits import SetIntent as SetIntent
from .edits import SetPose as SetPose
from .edits import SetSize as SetSize
from .edits import SetSupport as SetSupport
from .edits import Unrelate as Unrelate
from .edits import apply as apply
from .edits import apply_all as apply_all
from .edits import edit_from_json as edit_from_json
from .edits import edit_to_json as edit_to_json
from .edits import edits_from_json as edits_from_json
from .edits import invert as invert
from .fields import Quat as Quat
from .fields import Vec2 as Vec2
from .fields import Vec3 as Vec3
from .finish import CeilingFinish as CeilingFinish
from .finish import FloorFinish as FloorFinish
from .finish import RoomFinish as RoomFinish
from .finish import RoomLight as RoomLight
from .finish import WallAccent as WallAccent
from .finish import WallTiles as WallTiles
from .free_area import FreeArea as FreeArea
from .intent import PRIORITIES as PRIORITIES
from .intent import Intent as Intent
from .intent import Priority as Priority
from .io import EXAMPLES as EXAMPLES
from .migrate import SCHEMA as SCHEMA
from .migrate import migration as migration
from .model import Named as Named
from .model import Scene as Scene
from .model import id_of as id_of
from .model import point_of as point_of
from .objects import Dropped as Dropped
from .objects import Part as Part
from .objects import Pose as Pose
from .objects import SceneObject as SceneObject
from .objects import Support as Support
from .objects import Surface as Surface
from .objects import Zone as Zone
from .palette import Palette as Palette
from .relation import Relation as Relation
from .relation import wall_number as wall_number
from .room import Door as Door
from .room import Room as Room
from .room import Window as Window

__all__ = [
    "Add",
    "AnyEdit",
    "CATALOGUE",
    "CeilingFinish",
    "Door",
    "Dropped",
    "EDITS",
    "EXAMPLES",
    "Edit",
    "FloorFinish",
    "FreeArea",
    "Geometry",
    "InputError",
    "Intent",
    "MissingDependencyError",
    "Named",
    "PRIORITIES",
    "Palette",
    "ParamSpec",
    "Part",
    "Pose",
    "Priority",
    "Quat",
    "Relate",
    "Relation",
    "RelationSpec",
    "Remove",
    "Rename",
    "Replace",
    "Room",
    "RoomFinish",
    "RoomLight",
    "SCHEMA",
    "SIDES",
    "Scene",
    "SceneObject",
    "SceneWeaverError",
    "SetAttributes",
    "SetIntent",
    "SetPose",
    "SetSize",
    "SetSupport",
    "Support",
    "Surface",
    "TUCKED",
    "Unrelate",
    "WallAccent",
    "WallTiles",
    "Window",
    "Zone",
    "apply",
    "apply_all",
    "edit_from_json",
    "edit_to_json",
    "edits_from_json",
    "id_of",
    "invert",
    "migration",
    "point_of",
    "register_relation",
    "unregister_relation",
    "wall_number",
]
