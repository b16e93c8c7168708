"""A uniform grid finds the pairs; a full matrix and a hash table keep them, side by side."""

from __future__ import annotations

from game.lab.studies.broadphase.workloads import cell_size_study
from game.physics.broadphase import CoveringGrid, UniformGrid
from game.physics.broadphase.effects import BOUNDARY, HASHED_PAIRS, MATRIX_PAIRS, MOTION
from game.scenes.boxes import C05
from game.scenes.boxes.base import BoxesScene
from game.scenes.boxes.figure import draw_cells
from game.scenes.boxes.model.uniform_grid import UniformGridModel
from game.scenes.boxes.parameters import GridParameters
from game.scenes.boxes.readouts import grid_readouts
from game.scenes.boxes.view.uniform_grid import UniformGridView
from game.stage import Equation, Strip


class UniformGridScene(BoxesScene):
    """Boxes with random velocities move by explicit Euler and turn back at the boundary. A uniform grid, a
    dense matrix of cells without any hashing, finds all pairs that overlap in every step. Boxes are added,
    removed and updated in it as they come, go and move.

    Two pair managers are given the pairs, and say which ones began and which ended. One looks a pair up in a
    full matrix over all boxes, the other in a hash table. Their answers are compared in every step, their
    times and their memory are shown side by side. The matrix asks for one look and for memory that grows
    with the square of the boxes; above 4096 boxes it is left out here.

    In the textbook's grid every box stands in all cells that it covers. Here it may also stand in the cell of
    its lower corner alone, and look further for its partners.
    """

    name, task, title = C05.names
    effects = MOTION | BOUNDARY | MATRIX_PAIRS | HASHED_PAIRS
    study = cell_size_study

    parameters_type = GridParameters
    parameters: GridParameters
    model_type = UniformGridModel
    model: UniformGridModel
    view_type = UniformGridView

    phases = (
        ("uniform grid", lambda: UniformGrid((0.0, 0.0), (1.0, 1.0), 0.5)),
        ("covered cells", lambda: CoveringGrid((0.0, 0.0), (1.0, 1.0), 0.5)),
    )
    strips = (
        Strip("Pairs", "", ("pairs",)),
        Strip("Pair managers", "s", ("matrix", "hash")),
        Strip("Grid", "s", ("grid",)),
    )
    told = BoxesScene.told._replace(readouts=grid_readouts)
    figure = staticmethod(draw_cells)
    equations = (
        Equation("Motion", r"x' = x + v \Delta t", "explicit Euler"),
        Equation("Boundary", r"v' = -v", "beyond it and moving outwards"),
        Equation("Cell", r"i = \floor\left(\frac{x - x_0}{c}\right)", "Ericson 2005, 7.1"),
        Equation("Entries of a box", r"\left(1 + \frac{s}{c}\right)^2", "all covered cells, mean"),
        Equation("Place of a pair", r"k = \frac{i(2n - i - 1)}{2} + j - i - 1", "triangular matrix"),
        Equation(
            "Mean pairs",
            r"\frac{n(n-1)}{2} p_W p_H, \quad p_W = \frac{2 s L - s^2}{L^2}, \quad L = W - s",
            "boxes of side s, uniform in W × H; p_H as p_W",
        ),
    )
    try_this = (
        "Draw the cell size from 0.25 to 32: the time of the grid goes through a minimum.",
        "Choose all covered cells at a small cell size: entries grow with the square of size over cell.",
        "Raise the number to 4000 and watch the memory of the matrix; the hash table hardly grows.",
        "Put all boxes on one line, or cluster them: the load of a few cells, and the time, go up.",
    )
