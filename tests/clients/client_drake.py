"""Drake: ``scene.sdf``."""

from importlib.metadata import version

from measure import Client
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import AddMultibodyPlantSceneGraph
from pydrake.multibody.tree import BodyIndex, JointIndex, PrismaticJoint, RevoluteJoint
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder

STEP = 0.005


class Room(Client):
    """One model instance an object."""

    frames = "link"

    @classmethod
    def version(cls):
        return version("drake")

    def __init__(self, folder):
        builder = DiagramBuilder()
        self.plant, _ = AddMultibodyPlantSceneGraph(builder, STEP)
        Parser(self.plant).AddModels(f"{folder}/scene.sdf")
        self.plant.Finalize()
        self.diagram = builder.Build()
        self.context = self.diagram.CreateDefaultContext()
        self.own = self.plant.GetMyMutableContextFromRoot(self.context)
        found = [self.plant.get_joint(JointIndex(k)) for k in self.plant.GetJointIndices()]
        self.hinges = {self.name(j.child_body()): j for j in found if isinstance(j, (RevoluteJoint, PrismaticJoint))}

    def name(self, body):
        model = self.plant.GetModelInstanceName(body.model_instance())
        return model if body.name() == "base" else f"{model}.{body.name()}"

    def poses(self):
        found = {}
        for k in range(1, self.plant.num_bodies()):
            body = self.plant.get_body(BodyIndex(k))
            pose = self.plant.EvalBodyPoseInWorld(self.own, body)
            found[self.name(body)] = (pose.translation(), pose.rotation().ToQuaternion().wxyz())
        return found

    def joints(self):
        return {
            name: (
                "hinge" if isinstance(j, RevoluteJoint) else "slide",
                float(j.position_lower_limits()[0]),
                float(j.position_upper_limits()[0]),
            )
            for name, j in self.hinges.items()
        }

    def set_joint(self, name, value):
        joint = self.hinges[name]
        if isinstance(joint, RevoluteJoint):
            joint.set_angle(self.own, value)
        else:
            joint.set_translation(self.own, value)

    def step(self, seconds):
        Simulator(self.diagram, self.context).AdvanceTo(seconds)
