from typing import Any, Iterator, NamedTuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import errors as errors
from .errors import Error as Error

__version__: str

# (n, 2, d), (n, 2 * d), points (n, d), or (min, max) of arrays (n, d); d is 2 or 3.
_Boxes = Union[ArrayLike, tuple[ArrayLike, ArrayLike]]
_Ids = ArrayLike
_Words = Union[int, ArrayLike, None]
_Pairs = NDArray[np.uint32]

class Changes(NamedTuple):
    began: _Pairs
    ended: _Pairs

class Answers(NamedTuple):
    first: NDArray[np.int64]
    bodies: NDArray[np.uint32]
    values: NDArray[np.float64] | None
    def of(self, question: int) -> NDArray[np.uint32]: ...
    @property
    def counts(self) -> NDArray[np.int64]: ...
    @property
    def questions(self) -> NDArray[np.int64]: ...

def find_pairs(boxes: _Boxes, others: _Boxes | None = None, *, threads: int = 0, max_pairs: int = 0) -> _Pairs: ...
def count_pairs(boxes: _Boxes, others: _Boxes | None = None, *, threads: int = 0, max_pairs: int = 0) -> int: ...
def engines() -> list[tuple[str, str]]: ...

class World:
    def __init__(self, engine: str = "stream", **settings: Union[int, float, bool, str]) -> None: ...
    def insert(
        self, ids: _Ids, boxes: _Boxes, *, category: _Words = None, mask: _Words = None, static: _Words = None
    ) -> None: ...
    def add(
        self, boxes: _Boxes, *, category: _Words = None, mask: _Words = None, static: _Words = None
    ) -> NDArray[np.uint32]: ...
    def move(self, ids: _Ids, boxes: _Boxes) -> None: ...
    def remove(self, ids: _Ids) -> None: ...
    def set_filters(self, ids: _Ids, *, category: _Words = None, mask: _Words = None, static: _Words = None) -> None: ...
    def update(self) -> Changes: ...
    @property
    def pairs(self) -> _Pairs: ...
    def boxes(self, ids: _Ids) -> NDArray[np.float32]: ...
    def filters(self, ids: _Ids) -> tuple[NDArray[np.uint32], NDArray[np.uint32], NDArray[np.bool_]]: ...
    def __len__(self) -> int: ...
    def __contains__(self, id: int) -> bool: ...
    @property
    def engine(self) -> str: ...
    @property
    def capacity(self) -> int: ...
    def stream_view(self) -> tuple[NDArray[np.float32], NDArray[np.float32]] | None: ...
    @property
    def statistics(self) -> dict[str, Any]: ...
    def find_overlaps(
        self,
        boxes: _Boxes,
        distance: ArrayLike = 0.0,
        *,
        category: int | None = None,
        mask: int | None = None,
        static: bool | None = None,
    ) -> Answers: ...
    def any_overlaps(
        self,
        boxes: _Boxes,
        distance: ArrayLike = 0.0,
        *,
        category: int | None = None,
        mask: int | None = None,
        static: bool | None = None,
    ) -> NDArray[np.bool_]: ...
    def find_touches(
        self,
        boxes: _Boxes,
        direction: ArrayLike,
        end: ArrayLike = ...,
        *,
        category: int | None = None,
        mask: int | None = None,
        static: bool | None = None,
    ) -> Answers: ...
    def first_touches(
        self,
        boxes: _Boxes,
        direction: ArrayLike,
        end: ArrayLike = ...,
        *,
        category: int | None = None,
        mask: int | None = None,
        static: bool | None = None,
    ) -> tuple[NDArray[np.int64], NDArray[np.float64]]: ...
    def any_touches(
        self,
        boxes: _Boxes,
        direction: ArrayLike,
        end: ArrayLike = ...,
        *,
        category: int | None = None,
        mask: int | None = None,
        static: bool | None = None,
    ) -> NDArray[np.bool_]: ...
    def find_nearest(
        self,
        boxes: _Boxes,
        count: int = 1,
        most: float = ...,
        *,
        category: int | None = None,
        mask: int | None = None,
        static: bool | None = None,
    ) -> Answers: ...
    def find_within(
        self,
        boxes: _Boxes,
        distance: ArrayLike,
        *,
        category: int | None = None,
        mask: int | None = None,
        static: bool | None = None,
    ) -> Answers: ...
    def pairs_of(self, ids: _Ids) -> _Pairs: ...
    def prepare_queries(self) -> None: ...

class PairHistory:
    def __init__(self, most_pairs: int) -> None: ...
    def record(self, update_number: int, changes: Changes) -> None: ...
    def since(self, update_number: int) -> Changes: ...

class Frames:
    def __iter__(self) -> Iterator[NDArray[np.float32]]: ...
    def __next__(self) -> NDArray[np.float32]: ...
    def advance(self) -> bool: ...
    @property
    def name(self) -> str: ...
    @property
    def count(self) -> int | None: ...
    @property
    def boxes(self) -> NDArray[np.float32]: ...
    @property
    def bodies(self) -> NDArray[np.uint32]: ...
    @property
    def moved(self) -> NDArray[np.uint32]: ...
    @property
    def inserted(self) -> NDArray[np.uint32]: ...
    @property
    def removed(self) -> NDArray[np.uint32]: ...

def scene(
    name: str = "paper",
    *,
    bodies: int = 1024,
    seed: int = 1,
    moving: float | None = None,
    speed: float = 1.0,
    spinning: bool = False,
) -> Frames: ...
def scenes() -> list[tuple[str, str]]: ...
def read_frames(path: str) -> Frames: ...
def write_frames(path: str, frames: ArrayLike, *, name: str = "") -> None: ...
