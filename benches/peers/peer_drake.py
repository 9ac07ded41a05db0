"""Drake: a discrete MultibodyPlant with the convex contact solver SAP; the block on a planar joint, with two small spheres as its corners (see block.py).

The contacts are told to be stiffer than the step can resolve; what is left is then Drake's own regularisation ("near-rigid"). Its gravity is fixed once
a plant is finished, so the shaking is a force at the centre of mass, which is the same.
"""

from block import Body, by_rate, listed, serve  # first: what a simulator prints must not reach standard output

import os
from importlib.metadata import version

import numpy as np
from pydrake.all import (
    AddContactMaterial,
    AddMultibodyPlant,
    CoulombFriction,
    DiagramBuilder,
    FixedOffsetFrame,
    HalfSpace,
    MultibodyPlantConfig,
    PlanarJoint,
    ProximityProperties,
    RigidTransform,
    RotationMatrix,
    Simulator,
    SpatialInertia,
    Sphere,
    UnitInertia,
)

STIFFNESS = float(os.environ.get("STIFFNESS", 1e14))
RADIUS = 1e-6  # of the corners


def material():
    """No restitution: the time in which a contact relaxes is 0."""
    properties = ProximityProperties()
    AddContactMaterial(point_stiffness=STIFFNESS, friction=CoulombFriction(100.0, 100.0), properties=properties)
    properties.AddProperty("material", "relaxation_time", 0.0)
    return properties


def simulator(case, step):
    body = Body(case)
    builder = DiagramBuilder()
    config = MultibodyPlantConfig(time_step=step, discrete_contact_approximation="sap", contact_model="point")
    plant, _ = AddMultibodyPlant(config, builder)
    plant.mutable_gravity_field().set_gravity_vector([0.0, 0.0, -body.gravity])
    block = plant.AddRigidBody("block", SpatialInertia(1.0, np.zeros(3), UnitInertia(body.inertia, body.inertia, body.inertia)))
    # The joint turns from its x to its y, which is up: to the left, as seen against the third axis.
    upright = RigidTransform(RotationMatrix.MakeXRotation(np.pi / 2.0))
    wall = plant.AddFrame(FixedOffsetFrame("wall", plant.world_frame(), upright))
    face = plant.AddFrame(FixedOffsetFrame("face", block.body_frame(), upright))
    joint = plant.AddJoint(PlanarJoint("plane", wall, face))
    b, h = body.half_width, body.half_height
    plant.RegisterCollisionGeometry(plant.world_body(), RigidTransform(), HalfSpace(), "floor", material())
    for name, x in (("left", -b), ("right", b)):
        plant.RegisterCollisionGeometry(block, RigidTransform([x, 0.0, RADIUS - h]), Sphere(RADIUS), name, material())
    plant.Finalize()
    diagram = builder.Build()
    context = diagram.CreateDefaultContext()
    of_plant = plant.GetMyMutableContextFromRoot(context)
    joint.set_translation(of_plant, [0.0, h])
    force = plant.get_applied_generalized_force_input_port().FixValue(of_plant, np.zeros(3))
    runner = Simulator(diagram, context)
    runner.Initialize()
    return body, runner, joint, of_plant, force


def answer(case):
    def simulate(shaking):
        step = shaking.step
        body, runner, joint, context, force = simulator(case, step)
        for n in range(shaking.steps):
            force.GetMutableData().get_mutable_value()[0] = -body.shake * shaking((n + 0.5) * step)
            runner.AdvanceTo((n + 1) * step)
            yield (n + 1) * step, -joint.get_rotation(context) / case.alpha, -joint.get_angular_velocity(context) / case.alpha

    return listed(case, simulate, by_rate)


if __name__ == "__main__":
    serve("Drake", version("drake"), answer, "nonlinear")
