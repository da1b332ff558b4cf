"""One-shot pairs of boxes in every layout that NumPy has."""

import brute_force
import cellsweep
import numpy as np
import pytest


@pytest.fixture
def rng():
    return np.random.default_rng(1)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("axes", [2, 3])
@pytest.mark.parametrize("count", [0, 1, 2, 100, 3000])
def test_finds_what_comparing_all_finds(rng, dtype, axes, count):
    boxes = brute_force.random_boxes(rng, count, axes, dtype, edge=0.1)
    others = brute_force.random_boxes(rng, count // 2, axes, dtype, edge=0.1)
    found = cellsweep.find_pairs(boxes)
    assert found.dtype == np.uint32 and found.shape[1] == 2
    np.testing.assert_array_equal(found, brute_force.pairs(boxes))
    np.testing.assert_array_equal(cellsweep.find_pairs(boxes, others), brute_force.pairs(boxes, others))
    assert cellsweep.count_pairs(boxes) == len(found)
    assert cellsweep.count_pairs(boxes, others) == len(brute_force.pairs(boxes, others))


def layouts(boxes):
    """The same boxes lying otherwise."""
    count, _, axes = boxes.shape
    wide = np.zeros((count, 5, axes + 2), boxes.dtype)
    wide[:, 1::2, 1:-1] = boxes
    yield "flat", boxes.reshape(count, 2 * axes)
    yield "pair", (boxes[:, 0], boxes[:, 1])
    yield "fortran", np.asfortranarray(boxes)
    yield "strided", wide[:, 1::2, 1:-1]
    yield "axes last to first", np.ascontiguousarray(boxes[:, :, ::-1])[:, :, ::-1]
    yield "swapped bytes", boxes.astype(boxes.dtype.newbyteorder())
    yield "list", boxes.tolist()
    packed = np.zeros(count, np.dtype([("odd", "i1"), ("box", boxes.dtype, (2, axes))], align=False))
    packed["box"] = boxes
    yield "unaligned", packed["box"]


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("axes", [2, 3])
def test_reads_every_layout(rng, dtype, axes):
    boxes = brute_force.random_boxes(rng, 200, axes, dtype)
    expected = brute_force.pairs(boxes)
    for name, same in layouts(boxes):
        np.testing.assert_array_equal(cellsweep.find_pairs(same), expected, err_msg=name)
    backwards = boxes[::-1]
    np.testing.assert_array_equal(cellsweep.find_pairs(backwards), brute_force.pairs(backwards))


def test_takes_points_and_whole_numbers():
    boxes = np.array([[[0, 0, 0], [2, 2, 2]], [[5, 5, 5], [6, 6, 6]]])
    points = np.array([[2, 2, 2], [3, 3, 3], [5, 6, 5]])
    assert cellsweep.find_pairs(boxes, points).tolist() == [[0, 0], [1, 2]]
    assert cellsweep.find_pairs(boxes[0].ravel(), points[0]).tolist() == [[0, 0]]


def test_doubles_are_compared_as_doubles():
    near = np.array([[[0.0, 0.0], [1.0, 1.0]], [[1.0 + 1e-15, 0.0], [2.0, 1.0]]])
    assert len(cellsweep.find_pairs(near)) == 0
    assert len(cellsweep.find_pairs(near.astype(np.float32))) == 1


def test_any_number_of_threads_finds_the_same(rng):
    boxes = brute_force.random_boxes(rng, 20000, edge=0.05)
    expected = cellsweep.find_pairs(boxes, threads=1)
    for threads in 2, 3, 8:
        np.testing.assert_array_equal(cellsweep.find_pairs(boxes, threads=threads), expected)


def test_names_the_rows_at_fault(rng):
    boxes = brute_force.random_boxes(rng, 50)
    boxes[[7, 31], 0, 1] = [np.nan, 9]
    with pytest.raises(cellsweep.errors.InvalidBoxError, match=r"\(rows 7, 31\)") as raised:
        cellsweep.find_pairs(boxes)
    assert raised.value.rows == [7, 31] and raised.value.number == 2
    assert isinstance(raised.value, ValueError) and isinstance(raised.value, cellsweep.Error)


def test_refuses_what_are_no_boxes():
    for wrong in [np.zeros((3, 5)), np.zeros((3, 3, 3)), np.zeros((3, 2, 4)), np.zeros(()), np.zeros((1, 1, 2, 3))]:
        with pytest.raises(ValueError, match="shape"):
            cellsweep.find_pairs(wrong)
    with pytest.raises(ValueError, match="shape"):
        cellsweep.find_pairs((np.zeros((3, 3)), np.zeros((2, 3))))
    with pytest.raises(TypeError):
        cellsweep.find_pairs("boxes")
    with pytest.raises(cellsweep.errors.InputError, match="2 axes"):
        cellsweep.find_pairs(np.zeros((3, 2, 2)), np.zeros((3, 2, 3)))


def test_stops_at_a_limit():
    with pytest.raises(cellsweep.errors.CapacityError) as raised:
        cellsweep.find_pairs(np.zeros((10, 2, 3)), max_pairs=44)
    assert raised.value.limit == 44 and raised.value.setting == "max_pairs"
    assert len(cellsweep.find_pairs(np.zeros((10, 2, 3)), max_pairs=45)) == 45
