"""Texture coordinates in metres for any mesh."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from ..body import Mesh
from ..by_identity import ByIdentity
from .catalogue import found

_LONG = 4.0  # a piece is a bar when its variance along one way is this many times that along the next
_FLAT = 0.08  # share of a piece's area from which faces of one direction are a flat side
_SIDES = 12  # more directions than these are a round body


def uv_of(mesh: Mesh) -> np.ndarray:
    """Texture coordinates of the corners of each face, float32 [F, 3, 2] in metres.

    The mesh's own where it has some. Else each connected piece is projected from its sides: where the material has
    grain, u is the longest way of the piece, and each piece starts elsewhere in the pattern; else u is level and v up
    on upright faces, and (u, v) = (x, y) on level ones.
    """
    return mesh.uv if mesh.uv is not None else _projected(ByIdentity(mesh))


@lru_cache(maxsize=512)
def _projected(key: ByIdentity[Mesh]) -> np.ndarray:
    mesh = key.it
    if not len(mesh.faces):
        return np.zeros((0, 3, 2), dtype=np.float32)
    corners = mesh.vertices[mesh.faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(normal, axis=1)
    normal = normal / np.maximum(area, 1e-18)[:, None]
    piece = _pieces(mesh)
    grain = np.array([(p := found(m.texture)) is not None and p.grain for m in mesh.materials])[mesh.face_material]
    uv = np.empty((len(mesh.faces), 3, 2))
    if grain.any():
        uv[grain] = _along(mesh.vertices, mesh.faces[grain], corners[grain], normal[grain], piece[grain])
    if not grain.all():
        level = ~grain
        uv[level] = _upright(corners[level], normal[level], area[level], piece[level])
    uv = uv.astype(np.float32)
    uv.setflags(write=False)
    return uv


def _pieces(mesh: Mesh) -> np.ndarray:
    """The connected piece of each face [F]."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    f = mesh.faces
    edges = np.concatenate([f[:, :2], f[:, 1:]])
    shape = (len(mesh.vertices),) * 2
    graph = coo_matrix((np.ones(len(edges), dtype=np.int8), (edges[:, 0], edges[:, 1])), shape=shape)
    _, label = connected_components(graph, directed=False)
    return label[f[:, 0]]


def _along(
    vertices: np.ndarray, faces: np.ndarray, corners: np.ndarray, normal: np.ndarray, piece: np.ndarray
) -> np.ndarray:
    """Coordinates [F, 3, 2] in a frame of each piece: its longest way, the next and the last."""
    _, label = np.unique(piece, return_inverse=True)
    count = int(label.max()) + 1
    owner = np.full(len(vertices), -1)
    owner[faces.ravel()] = np.repeat(label, 3)
    points, owner = vertices[owner >= 0], owner[owner >= 0]
    low, high = np.full((count, 3), np.inf), np.full((count, 3), -np.inf)
    np.minimum.at(low, owner, points)
    np.maximum.at(high, owner, points)
    frame = np.eye(3)[np.argsort(low - high, axis=1, kind="stable")]  # [P, axis, xyz], the longest first
    weight = np.bincount(owner, minlength=count)[:, None]
    mean = np.stack([np.bincount(owner, points[:, k], count) for k in range(3)], 1) / weight
    apart = points - mean[owner]
    outer = apart[:, :, None] * apart[:, None, :]
    spread = np.stack([np.bincount(owner, outer[:, i, j], count) for i in range(3) for j in range(3)], 1)
    values, vectors = np.linalg.eigh(spread.reshape(count, 3, 3))
    bar = values[:, 2] > _LONG * np.maximum(values[:, 1], 1e-18)
    own = np.swapaxes(vectors, 1, 2)[:, ::-1]
    slanted = bar & (np.abs(own[:, 0]).max(axis=1) < 0.9999)
    if slanted.any():
        first = own[slanted, 0] * np.sign(own[slanted, 0].sum(axis=1, keepdims=True) + 1e-9)
        # The bar's sides keep to the axes as far as they can: those of a leg that leans are still front and side.
        side = frame[slanted, 1] - (frame[slanted, 1] * first).sum(1, keepdims=True) * first
        side /= np.maximum(np.linalg.norm(side, axis=1, keepdims=True), 1e-9)
        frame[slanted] = np.stack([first, side, np.cross(first, side)], 1)
    local = np.einsum("fcx,fax->fca", corners, frame[label])
    facing = np.abs(np.einsum("fx,fax->fa", normal, frame[label])).argmax(axis=1)
    pick = np.array([[1, 2], [0, 2], [0, 1]])[facing]
    uv = np.take_along_axis(local, np.repeat(pick[:, None, :], 3, 1), axis=2)
    middle = (low + high) / 2
    start = np.sin(np.round(middle, 4) @ np.array([[12.9898, 39.346], [78.233, 11.135], [37.719, 83.155]])) * 437.5453
    return uv + np.mod(start, 7.0)[label][:, None, :]


def _upright(corners: np.ndarray, normal: np.ndarray, area: np.ndarray, piece: np.ndarray) -> np.ndarray:
    """Coordinates [F, 3, 2]: along the face and up where it stands, x and y where it lies."""
    lying = np.abs(normal[:, 2]) > 0.707
    facing = normal[:, :2] / np.maximum(np.linalg.norm(normal[:, :2], axis=1, keepdims=True), 1e-12)
    # Flat sides are seen from straight ahead; round bodies from four sides, else each facet would start anew.
    angle = np.round(np.degrees(np.arctan2(facing[:, 1], facing[:, 0]))).astype(int) % 360
    sides, group = np.unique(piece * 1000 + angle, return_inverse=True)
    share = np.bincount(group, area)[group] / np.bincount(piece, area)[piece]
    flat = (share >= _FLAT) | (np.bincount(sides // 1000)[piece] <= _SIDES)
    quarter = np.radians(np.round(angle / 90) * 90)
    four = np.stack([np.cos(quarter), np.sin(quarter)], 1).round()
    facing = np.where(flat[:, None], facing, four)
    u = corners[:, :, 1] * facing[:, None, 0] - corners[:, :, 0] * facing[:, None, 1]
    standing = np.stack([u, corners[:, :, 2]], 2)
    return np.where(lying[:, None, None], corners[:, :, :2], standing)
