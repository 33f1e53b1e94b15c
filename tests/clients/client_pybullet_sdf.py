"""PyBullet: ``scene.sdf`` as written for it."""

import client_pybullet
import pybullet as p


class Room(client_pybullet.Room):
    """One body a model."""

    def load(self, folder):
        return {p.getBodyInfo(body)[1].decode(): body for body in p.loadSDF(f"{folder}/scene.sdf")}
