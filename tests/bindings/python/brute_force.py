"""What the module's answers are held against: every box with every other, in NumPy."""

import numpy as np


def random_boxes(rng, count, axes=3, dtype=np.float32, edge=0.25):
    """Boxes of which some share faces: coordinates are multiples of 2**-10."""
    low = np.round(rng.random((count, axes)) * 1024) / 1024
    size = np.round(rng.random((count, axes)) * edge * 1024) / 1024
    return np.stack([low, low + size], axis=1).astype(dtype)


def overlaps(a, b):
    """(len(a), len(b)) bool."""
    return np.all((a[:, None, 0] <= b[None, :, 1]) & (b[None, :, 0] <= a[:, None, 1]), axis=2)


def pairs(a, b=None):
    """(m, 2) rows, ascending."""
    if b is not None:
        return np.argwhere(overlaps(a, b))
    return np.argwhere(np.triu(overlaps(a, a), 1))


def distances(a, b):
    """(len(a), len(b)) between boxes."""
    a, b = a.astype(np.float64), b.astype(np.float64)
    gap = np.maximum(0, np.maximum(a[:, None, 0] - b[None, :, 1], b[None, :, 0] - a[:, None, 1]))
    return np.sqrt(gap[..., 0] ** 2 + gap[..., 1] ** 2 + gap[..., 2] ** 2)
