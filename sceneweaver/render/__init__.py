"""Pictures of scenes, drawn without a display."""

from sceneweaver.render.topview import draw_top as draw_top
from sceneweaver.render.topview import save_top as save_top
from sceneweaver.render.tracing import Quality as Quality
from sceneweaver.render.views import EyeLevel as EyeLevel
from sceneweaver.render.views import draw_room as draw_room
from sceneweaver.render.views import draw_rooms as draw_rooms

__all__ = ["EyeLevel", "Quality", "draw_room", "draw_rooms", "draw_top", "save_top"]
