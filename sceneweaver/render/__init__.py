"""Pictures of scenes, drawn without a display."""

from sceneweaver.render.topview import draw_top as draw_top
from sceneweaver.render.topview import save_top as save_top

__all__ = ["draw_top", "save_top"]
