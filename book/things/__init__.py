"""The things of the course's figures, the same in all chapters.

A chapter imports this module and says `things.robot(pose)`. Where they are drawn:

- `robots`: the small robot, its vacuum cousin, omni robot, platform; pad and dock
- `wheels`: wheels of all kinds from above, and one with an encoder from the side
- `vehicles`: car, bus, bicycle's wheel, steering rod, shopping trolley
- `arms`: the arm
- `room`: camera, box, ball, bench, ruler, tracing paper, kerb, shelf, walls
- `space`, of `meshes`: the arm, the camera and others in space; `graph`: a graph in a picture

Places are (x, y, angle) in metres and radians, as numbers or expressions; so are angles of what
turns and ways that wheels have rolled. Sizes are numbers. `look` is "", "ghost" or "wrong".
"""

from book.things.arms import arm
from book.things.robots import dock, omni_robot, pad, pad_lights, platform, robot, vacuum
from book.things.room import (
    ball,
    bench,
    camera_above,
    ceiling_camera,
    kerb,
    lamplight,
    parcel,
    ruler,
    sheet,
    shelf,
    tiled_room,
    tracing_paper,
    walls,
)
from book.things.vehicles import bicycle_wheel, bus, car, rod, trolley
from book.things.wheels import (
    ball_wheel,
    castor,
    counter,
    encoder_wheel,
    light_gate,
    mecanum_wheel,
    omni_wheel,
    roller_wheel,
    steered_wheel,
    wheel,
)

__all__ = [
    "arm", "ball", "ball_wheel", "bench", "bicycle_wheel", "bus", "camera_above", "car",
    "castor", "ceiling_camera", "counter", "dock", "encoder_wheel", "kerb", "lamplight",
    "light_gate", "mecanum_wheel", "omni_robot", "omni_wheel", "pad", "pad_lights", "parcel",
    "platform", "robot", "rod", "roller_wheel", "ruler", "sheet", "shelf", "steered_wheel",
    "tiled_room", "tracing_paper", "trolley", "vacuum", "walls", "wheel",
]  # fmt: skip
