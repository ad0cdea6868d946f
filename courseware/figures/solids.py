"""Solids: the bodies of a picture in space, turned, shaded and sorted by the script.

A `Mesh` is data: corners in metres and the faces between them. A `Solid` is a body of meshes at a
pose, `VIEW.solid(meshes, R, at)`; only the pose's twelve numbers are computed with the figure's
symbols, so the entries of R get names: `R = steps.add("r", …)`. Faces that look away are not
drawn, the others from far to near. So meshes are convex, or so thin that it does not show.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from courseware.figures.computed_parts import Expr, Kind

Point3 = tuple[float, float, float]
Face = tuple[int, ...]


@dataclass(frozen=True)
class Mesh:
    """Corners, and faces as places of corners, counter-clockwise for one who looks from outside.

    Lines are drawn where a face meets one that looks away, or quite another way.

    Args:
        kind: the tone of a material, or a look.
        dots: discs printed on a face, by its place, each (along the first edge, to the left of
            that, radius) in metres from the middle, or with a tone after them.
        edge: the tone of its lines, by default its kind's.
    """

    kind: Kind
    corners: tuple[Point3, ...]
    faces: tuple[Face, ...]
    dots: Mapping[int, Sequence[tuple[Any, ...]]] = field(default_factory=dict)
    edge: str = ""


@dataclass(frozen=True)
class Solid:
    """A body at a pose: R (3, 3) turns it, or stretches it, too; `at` is where its origin is.

    view: of the picture. floor: at which height its shadow falls, if it has one. opacity: below 1
    it is a ghost, of one colour. behind: how far it is put back, as a floor is.
    """

    meshes: tuple[Mesh, ...]
    R: Any
    at: Sequence[Expr]
    view: tuple[Expr, Expr]
    floor: float | None = None
    opacity: float = 1.0
    behind: float = 0.0

    @property
    def numbers(self) -> list[Expr]:
        """The numbers that are computed for it: the view's two angles, R row by row, the place."""
        return [*self.view, *self.R, *self.at]

    @property
    def data(self) -> list[dict[str, Any]]:
        """The meshes as the script reads them."""
        return [
            vars(mesh) | {"corners": [[round(x, 3) for x in corner] for corner in mesh.corners]}
            for mesh in self.meshes
        ]
