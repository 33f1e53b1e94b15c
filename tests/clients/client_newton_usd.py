"""Newton: ``scene.usdc``, stepped by its MuJoCo solver."""

import client_newton
from measure import usd_name
from newton.usd import SchemaResolverMjc, SchemaResolverNewton, SchemaResolverPhysx


class Room(client_newton.Room):
    """The room by USD."""

    bodies_fixed = False

    def fill(self, builder, folder):
        resolvers = [SchemaResolverNewton(), SchemaResolverMjc(), SchemaResolverPhysx()]
        builder.add_usd(f"{folder}/scene.usdc", schema_resolvers=resolvers)

    def name(self, label):
        return usd_name(label)
