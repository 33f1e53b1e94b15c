"""Homes as robots move in them: shortest ways, graphs of rooms and doors, maps, and episodes."""

from .episodes import Episode as Episode
from .episodes import EpisodeSet as EpisodeSet
from .episodes import Goal as Goal
from .episodes import object_goal_episodes as object_goal_episodes
from .episodes import point_goal_episodes as point_goal_episodes
from .graph import JointEdge as JointEdge
from .graph import NavigationGraph as NavigationGraph
from .graph import RoomNode as RoomNode
from .graph import navigation_graph as navigation_graph
from .habitat import load_episodes as load_episodes
from .habitat import read_episodes as read_episodes
from .habitat import save_episodes as save_episodes
from .habitat import write_episodes as write_episodes
from .maps import OccupancyMap as OccupancyMap
from .maps import occupancy_map as occupancy_map
from .roadmap import Distances as Distances
from .roadmap import Path as Path
from .roadmap import Roadmap as Roadmap
from .roadmap import shortest_path as shortest_path

__all__ = [
    "Distances",
    "Episode",
    "EpisodeSet",
    "Goal",
    "JointEdge",
    "NavigationGraph",
    "OccupancyMap",
    "Path",
    "Roadmap",
    "RoomNode",
    "load_episodes",
    "navigation_graph",
    "object_goal_episodes",
    "occupancy_map",
    "point_goal_episodes",
    "read_episodes",
    "save_episodes",
    "shortest_path",
    "write_episodes",
]
