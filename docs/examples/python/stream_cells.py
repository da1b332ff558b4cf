"""Draws how engine `stream` sees a world: its cells within cells, and the fat boxes around bodies that move.

    python3 stream_cells.py [FOLDER]       needs NumPy and matplotlib
"""

import pathlib
import sys

import cellsweep
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.collections import PatchCollection
from matplotlib.patches import Rectangle

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
folder.mkdir(parents=True, exist_ok=True)
rng = np.random.default_rng(7)


def draw(axes, boxes, **style):
    corners, sizes = boxes[:, 0, :2], boxes[:, 1, :2] - boxes[:, 0, :2]
    patches = [Rectangle(corner, *size) for corner, size in zip(corners, sizes)]
    axes.add_collection(PatchCollection(patches, **style))


def finish(figure, axes, window, name):
    axes.set_xlim(*window)
    axes.set_ylim(*window)
    axes.set_aspect("equal")
    axes.set_axis_off()
    figure.savefig(folder / name, dpi=110, bbox_inches="tight")
    plt.close(figure)
    print(folder / name)


# A flat world: bodies spread out thinly, and three crowds.
def flat_boxes(middles, size):
    return np.stack([middles - size / 2, middles + size / 2], axis=1)


everywhere = flat_boxes(100 * rng.random((6000, 2)), 0.4)
crowds = [flat_boxes(rng.normal(middle, 3, (1500, 2)), 0.2) for middle in [(25, 30), (60, 75), (78, 28)]]
world = cellsweep.World()
ids = world.add(np.concatenate([everywhere, *crowds]))
world.update()
_, cells = world.stream_view()
bodies = world.boxes(ids)
figure, axes = plt.subplots(figsize=(8, 8))
draw(axes, bodies, facecolors="tab:red", alpha=0.4, linewidths=0)
draw(axes, cells, facecolors="none", edgecolors="black", linewidths=0.7)
finish(figure, axes, (0, 100), "stream-cells.png")

# Bodies that move: each in the fat box that it may move in before anybody looks at the cells again.
middles = 12 * rng.random((60, 2))
way = rng.normal(0, 0.03, (60, 2))
world = cellsweep.World(margin=0.01)  # so few bodies have fat boxes only where a margin is asked for, if most of them move
ids = world.add(flat_boxes(middles, 0.5))
world.update()
for step in range(1, 12):
    world.move(ids, flat_boxes(middles + step * way, 0.5))
    world.update()
fat, _ = world.stream_view()
figure, axes = plt.subplots(figsize=(7, 7))
draw(axes, fat, facecolors="none", edgecolors="tab:blue", linewidths=1)
draw(axes, world.boxes(ids), facecolors="tab:red", alpha=0.6, linewidths=0)
finish(figure, axes, (-0.5, 12.5), "stream-fat.png")
