"""Genesis: ``scene.xml``."""

import genesis as gs
import numpy as np
from measure import Client

STEP = 0.004


class Room(Client):
    """The room as one rigid entity."""

    @classmethod
    def version(cls):
        return gs.__version__

    def __init__(self, folder):
        gs.init(backend=gs.cpu, logging_level="error")
        self.scene = gs.Scene(sim_options=gs.options.SimOptions(dt=STEP), show_viewer=False)
        self.room = self.scene.add_entity(gs.morphs.MJCF(file=f"{folder}/scene.xml"))
        self.scene.build()

    def poses(self):
        at, turn = self.room.get_links_pos().numpy(), self.room.get_links_quat().numpy()
        return {link.name: (at[k], turn[k]) for k, link in enumerate(self.room.links)}

    def hinges(self):
        kinds = {gs.JOINT_TYPE.REVOLUTE: "hinge", gs.JOINT_TYPE.PRISMATIC: "slide"}
        return {j.link.name: (j, kinds[j.type]) for j in self.room.joints if j.type in kinds}

    def joints(self):
        low, high = (v.numpy() for v in self.room.get_dofs_limit())
        return {
            name: (kind, float(low[j.dofs_idx_local[0]]), float(high[j.dofs_idx_local[0]]))
            for name, (j, kind) in self.hinges().items()
        }

    def set_joint(self, name, value):
        self.room.set_dofs_position(np.array([value]), dofs_idx_local=self.hinges()[name][0].dofs_idx_local)

    def step(self, seconds):
        for _ in range(round(seconds / STEP)):
            self.scene.step()
