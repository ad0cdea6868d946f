"""Arguments of the functions of `robokin.frames`."""

from arguments import POINT, TURNED, data, frame, length, matrix, row
from robokin.frames import FrameGraph

SE2 = [[0.6, -0.8, 2.0], [0.8, 0.6, -1.0], [0.0, 0.0, 1.0]]
SE3 = [[0.0, 0.0, 1.0, 2.0], [-1.0, 0.0, 0.0, 3.0], [0.0, -1.0, 0.0, 4.0], [0.0, 0.0, 0.0, 1.0]]


def graph():
    """A graph of two frames."""
    made = FrameGraph()
    made.add("d", "b", SE2)
    return made


ROWS = {
    "se2": row([(3, 3)], x=data(1.0), y=data(2.0), theta=data(0.3)),
    "se3": row([(4, 4)], rotation=matrix(TURNED), position=data(POINT)),
    "pose": row([(3,)], T=matrix(SE2)),
    "dh": row([(4, 4)], theta=data(0.3), d=data(0.1), a=data(0.4), alpha=data(-0.7)),
    "inverse": row([(3, 3)], T=matrix(SE2)),
    "inverse in space": row([(4, 4)], T=matrix(SE3)),
    "compose": row([(3, 3)], positional=True, first=matrix(SE2), second=matrix(SE2)),
    "compose in space": row([(4, 4)], positional=True, first=matrix(SE3), second=matrix(SE3)),
    "transform": row([(2,)], T=matrix(SE2), points=data([0.3, 0.4])),
    "transform in space": row([(3,)], T=matrix(SE3), points=data(POINT)),
    "check_rotation": row(None, False, R=matrix(TURNED), tol=length(1e-9)),
    "FrameGraph.add": row(None, on=graph, a=frame("d"), b=frame("e"), T_ab=matrix(SE2)),
    "FrameGraph.get": row([(3, 3)], on=graph, a=frame("b"), b=frame("d")),
    "FrameGraph.path": row(None, on=graph, a=frame("b"), b=frame("d")),
}
