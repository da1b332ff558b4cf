"""Times the module for Python: beside the same call in C, SciPy's cKDTree, and rtree.

    ./run bench python [--boxes N,...] [--rounds N] [--json FILE]

Boxes are cubes of one edge at random places, dense enough for four pairs a box, so that cKDTree can do the work, too:
centers nearer than an edge on each axis. Each row is the median of rounds in which all take turns, one thread, and what is
found is compared before anything is timed. rtree's index is built and asked box by box, as its users do, up to 10,000.
"""

import argparse
import ctypes
import json
import statistics
import sys
import time

import cellsweep
import numpy as np


class Boxes(ctypes.Structure):
    """cellsweep_boxes of cellsweep/c/boxes.h."""

    class Coordinates(ctypes.Structure):
        _fields_ = [("first", ctypes.c_void_p), ("stride", ctypes.c_ssize_t)]

    _fields_ = [
        ("count", ctypes.c_size_t),
        ("axes", ctypes.c_uint32),
        ("number", ctypes.c_uint32),
        ("min", Coordinates * 3),
        ("max", Coordinates * 3),
    ]

    def __init__(self, array):
        super().__init__(len(array), 3, 0)
        for axis in range(3):
            self.min[axis].first = array.ctypes.data + 4 * axis
            self.max[axis].first = array.ctypes.data + 12 + 4 * axis
            self.min[axis].stride = self.max[axis].stride = 24


class FindOptions(ctypes.Structure):
    """cellsweep_find_options of cellsweep/c/find_pairs.h."""

    _fields_ = [
        ("size", ctypes.c_size_t),
        ("threads", ctypes.c_uint),
        ("isa", ctypes.c_uint32),
        ("executor", ctypes.c_void_p),
        ("max_pairs", ctypes.c_uint64),
    ]


class CLibrary:
    """The same search through the face for C, without any Python in it."""

    def __init__(self, path):
        self.library = ctypes.CDLL(path)
        self.library.cellsweep_find_pairs.argtypes = [Boxes] + [ctypes.c_void_p] * 3
        self.library.cellsweep_listed_pairs.restype = ctypes.c_void_p

    def find(self, boxes):
        made = ctypes.c_void_p()
        options = FindOptions(size=ctypes.sizeof(FindOptions), threads=1)
        assert self.library.cellsweep_pair_list_create(ctypes.byref(made), None) == 0
        assert self.library.cellsweep_find_pairs(Boxes(boxes), ctypes.byref(options), made, None) == 0
        count = ctypes.c_size_t()
        self.library.cellsweep_listed_pairs(made, ctypes.byref(count))
        self.library.cellsweep_pair_list_destroy(made)
        return count.value


def make_boxes(count, edge=1.0):
    """Four pairs a box: a cube of side 2 edges around each center holds eight others, each pair is seen twice."""
    rng = np.random.default_rng(1)
    side = edge * count ** (1 / 3)
    low = (rng.random((count, 3)) * side).astype(np.float32)
    return np.ascontiguousarray(np.stack([low, low + np.float32(edge)], axis=1))


def kd_tree_pairs(boxes):
    from scipy.spatial import cKDTree

    # Doubles: a float's rounding of `low + edge` decides in the last bit who touches.
    return cKDTree(boxes[:, 0].astype(np.float64)).query_pairs(1.0, p=np.inf, output_type="ndarray")


def r_tree_pairs(boxes):
    from rtree import index

    flat = boxes.reshape(-1, 6).astype(np.float64)
    properties = index.Property(dimension=3)
    tree = index.Index(((i, box, None) for i, box in enumerate(flat)), properties=properties)
    return sum(1 for i, box in enumerate(flat) for other in tree.intersection(box) if other > i)


def world_frame(boxes):
    """A frame in which all boxes move: the arrays in, the changes out."""
    world = cellsweep.World(threads=1)
    ids = world.add(boxes)
    world.update()
    moved = boxes + np.float32(0.001)
    turn = [boxes, moved]

    def frame():
        turn.reverse()
        world.move(ids, turn[0])
        world.update()

    return frame


def rows_for(boxes, library):
    rows = {
        "cellsweep": lambda: cellsweep.find_pairs(boxes, threads=1),
        "cellsweep, float64": lambda doubles=boxes.astype(np.float64): cellsweep.find_pairs(doubles, threads=1),
        "cellsweep from C": lambda: library.find(boxes),
        "cellsweep.World, all move": world_frame(boxes),
        "scipy cKDTree": lambda: kd_tree_pairs(boxes),
    }
    if len(boxes) <= 10_000:
        rows["rtree"] = lambda: r_tree_pairs(boxes)
    return rows


def check(boxes, library):
    pairs = cellsweep.find_pairs(boxes, threads=1)
    if library.find(boxes) != len(pairs):
        sys.exit("The call from C finds other pairs.")
    # Those that touch to the last bit are cKDTree's own affair.
    difference = abs(len(kd_tree_pairs(boxes)) - len(pairs))
    if difference > len(pairs) // 10_000:
        sys.exit(f"cKDTree finds {difference} pairs more or fewer than {len(pairs)}.")
    return len(pairs)


def median_times(rows, rounds):
    times = {name: [] for name in rows}
    for _ in range(rounds):
        for name, call in rows.items():
            start = time.perf_counter()
            call()
            times[name].append(time.perf_counter() - start)
    return {name: statistics.median(of) for name, of in times.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("library", help=argparse.SUPPRESS)
    parser.add_argument("--boxes", default="1000,10000,100000", help="how many, with commas between (%(default)s)")
    parser.add_argument("--rounds", type=int, default=15, help="of which the median is shown (%(default)s)")
    parser.add_argument("--json", help="a file for the numbers, too")
    arguments = parser.parse_args()
    library = CLibrary(arguments.library)
    results = []
    for count in map(int, arguments.boxes.split(",")):
        boxes = make_boxes(count)
        found = check(boxes, library)
        print(f"{count:,} boxes, {found:,} pairs")
        medians = median_times(rows_for(boxes, library), arguments.rounds)
        for name, seconds in medians.items():
            ratio = seconds / medians["cellsweep"]
            print(f"  {name:<28} {1000 * seconds:10.3f} ms {ratio:8.2f} times")
            results.append({"boxes": count, "pairs": found, "row": name, "milliseconds": 1000 * seconds})
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump(results, file, indent=1)


if __name__ == "__main__":
    main()
