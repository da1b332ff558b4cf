"""A tour of cellsweep in Python: pairs at once, a world that moves, questions to it. Draws four pictures.

    python3 tour.py [FOLDER]       needs NumPy and matplotlib

The cells between the lines `# %%` run one by one in editors that know notebooks.
"""

# %% Boxes are arrays (n, 2, d): a minimum and a maximum. Pairs are rows of them.
import pathlib
import sys

import cellsweep
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.collections import LineCollection, PatchCollection
from matplotlib.patches import Rectangle

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
folder.mkdir(parents=True, exist_ok=True)
rng = np.random.default_rng(4)
low = rng.random((150, 2))
boxes = np.stack([low, low + 0.02 + 0.06 * rng.random((150, 2))], axis=1)
pairs = cellsweep.find_pairs(boxes)
print(f"{len(pairs)} pairs of {len(boxes)} boxes, the first is {pairs[0]}")


# %% A picture: boxes that overlap another are red, and their centers are joined.
def draw_boxes(axes, boxes, colors):
    sizes = boxes[:, 1] - boxes[:, 0]
    patches = [Rectangle(corner, *size) for corner, size in zip(boxes[:, 0], sizes)]
    axes.add_collection(PatchCollection(patches, facecolors=colors, edgecolors="black", linewidths=0.5, alpha=0.5))
    axes.set_xlim(boxes[:, 0, 0].min(), boxes[:, 1, 0].max())
    axes.set_ylim(boxes[:, 0, 1].min(), boxes[:, 1, 1].max())
    axes.set_aspect("equal")
    axes.set_axis_off()


def save(figure, name):
    figure.savefig(folder / name, dpi=100, bbox_inches="tight")
    plt.close(figure)
    print(folder / name)


figure, axes = plt.subplots(figsize=(7, 7))
colors = np.full(len(boxes), "lightgray", dtype=object)
colors[np.unique(pairs)] = "tab:red"
draw_boxes(axes, boxes, colors)
centers = boxes.mean(axis=1)
axes.add_collection(LineCollection(centers[pairs], colors="black", linewidths=1))
axes.set_title(f"{len(pairs)} pairs of {len(boxes)} boxes")
save(figure, "pairs.png")

# %% Two sets: which of a grid's squares does each of some points lie in? Points are boxes without extent.
edges = np.arange(8) / 8
corners = np.stack(np.meshgrid(edges, edges, indexing="ij"), axis=-1).reshape(-1, 2)
squares = np.stack([corners, corners + 1 / 8], axis=1)
points = rng.normal(0.5, 0.15, (3000, 2))
square, point = cellsweep.find_pairs(squares, points).T
counts = np.bincount(square, minlength=len(squares))
figure, axes = plt.subplots(figsize=(6, 6))
draw_boxes(axes, squares, plt.cm.viridis(counts / counts.max()))
axes.plot(*points.T, "k.", markersize=1)
axes.set_title(f"{len(points)} points in {len(squares)} squares")
save(figure, "squares.png")

# %% A world: boxes that move, and what began and ended in each frame.
world = cellsweep.World()
frames = cellsweep.scene("clustered", bodies=5000, moving=0.3)
ids = world.add(next(frames))
world.update()
began, ended = [], []
for _, frame in zip(range(200), frames):
    world.move(frames.moved, frame[frames.moved])
    changes = world.update()
    began.append(len(changes.began))
    ended.append(len(changes.ended))
figure, axes = plt.subplots(figsize=(8, 3))
axes.plot(began, label="began")
axes.plot(ended, label="ended")
axes.set_xlabel("frame")
axes.set_ylabel("pairs")
axes.legend()
axes.set_title(f"{len(world)} bodies, {len(world.pairs)} pairs in the end")
save(figure, "changes.png")

# %% Questions: a camera's rays, the first body on each, and how far it is.
spread = np.linspace(-1, 1, 240)
across, up = np.meshgrid(spread, spread)
room = world.boxes(ids)
middle = (room[:, 0].min(axis=0) + room[:, 1].max(axis=0)) / 2
size = float(np.ptp(room))
eye = (middle - [1.2 * size, 0, 0]).astype(np.float32)
directions = np.stack([np.ones_like(across), 0.5 * across, 0.5 * up], axis=-1).reshape(-1, 3)
world.prepare_queries()
body, distance = world.first_touches(np.broadcast_to(eye, (len(directions), 3)), directions)
print(f"{(body >= 0).mean():.0%} of {len(body)} rays meet a body")
figure, axes = plt.subplots(figsize=(6, 6))
axes.imshow(distance.reshape(across.shape), origin="lower", cmap="magma_r")
axes.set_axis_off()
axes.set_title("How far the first body on each ray is")
save(figure, "rays.png")

# %% The nearest neighbours of some bodies; the first of each is the body itself.
nearest = world.find_nearest(room[:4], 3)
for i in range(4):
    print(f"body {ids[i]}: nearest are {nearest.of(i)[1:]}")
