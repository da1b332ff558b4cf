"""Which axis-aligned boxes overlap: exactly, at once or in a world that moves.

    pairs = cellsweep.find_pairs(boxes)          # (m, 2) rows of boxes (n, 2, 3)

    world = cellsweep.World()
    ids = world.add(boxes)
    world.update()
    world.move(ids, boxes + step)
    began, ended = world.update()                # pairs of ids
    nearest = world.find_nearest(points, 8)      # Answers
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from . import errors
from ._cellsweep import (
    Frames,
    PairHistory,
    World,
    __version__,
    count_pairs,
    engines,
    find_pairs,
    read_frames,
    scene,
    scenes,
    write_frames,
)
from .errors import Error

__all__ = [
    "Answers",
    "Changes",
    "Error",
    "Frames",
    "PairHistory",
    "World",
    "count_pairs",
    "engines",
    "errors",
    "find_pairs",
    "read_frames",
    "scene",
    "scenes",
    "write_frames",
]


class Changes(NamedTuple):
    """What changed between two updates: arrays (m, 2) of ids, ascending, the smaller id first."""

    began: np.ndarray
    ended: np.ndarray


class Answers(NamedTuple):
    """Lists of answers to n questions, one after the other.

    Those to question i are bodies[first[i]:first[i + 1]], which of(i) gives; `values` are times or distances, None
    where there are none.
    """

    first: np.ndarray
    bodies: np.ndarray
    values: np.ndarray | None

    def of(self, question: int) -> np.ndarray:
        """The ids that answer one question."""
        return self.bodies[self.first[question] : self.first[question + 1]]

    @property
    def counts(self) -> np.ndarray:
        """How many answers each question has, (n,)."""
        return np.diff(self.first)

    @property
    def questions(self) -> np.ndarray:
        """The question that each answer is to, as long as `bodies`."""
        return np.repeat(np.arange(len(self.first) - 1), self.counts)
