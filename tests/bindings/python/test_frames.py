"""Scenes and recordings from Python."""

import itertools

import cellsweep
import numpy as np
import pytest
from cellsweep import errors


def test_scenes_are_the_same_bits_each_time():
    first = list(itertools.islice(cellsweep.scene("clustered", bodies=100, seed=7), 5))
    again = list(itertools.islice(cellsweep.scene("clustered", bodies=100, seed=7), 5))
    other = next(cellsweep.scene("clustered", bodies=100, seed=8))
    np.testing.assert_array_equal(first, again)
    assert first[0].shape == (100, 2, 3) and not np.array_equal(first[0], other)
    assert {"paper", "uniform", "pile"} <= {name for name, _ in cellsweep.scenes()}


def test_a_scene_tells_who_moved():
    frames = cellsweep.scene("uniform", bodies=200, moving=0.2)
    before = next(frames)
    assert len(frames.moved) == 0 and frames.count is None and frames.name
    after = next(frames)
    changed = np.flatnonzero((before != after).any(axis=(1, 2)))
    np.testing.assert_array_equal(frames.moved, changed)
    np.testing.assert_array_equal(frames.bodies, np.arange(200))
    assert frames.advance() and not np.array_equal(frames.boxes, after)


@pytest.mark.parametrize("ending", ["npy", "aabbs"])
def test_what_was_written_is_read(tmp_path, ending):
    frames = np.array(list(itertools.islice(cellsweep.scene("varied", bodies=50), 4)))
    path = str(tmp_path / f"varied.{ending}")
    cellsweep.write_frames(path, frames, name="varied")
    read = cellsweep.read_frames(path)
    assert read.count == 4
    np.testing.assert_array_equal(list(read), frames)


def test_bad_files_and_settings_are_refused(tmp_path):
    with pytest.raises(errors.OptionError, match="nowhere"):
        cellsweep.scene("nowhere")
    with pytest.raises(errors.OptionError):
        cellsweep.scene(moving=2.0)
    with pytest.raises(errors.InputError, match="missing.npy"):
        cellsweep.read_frames(str(tmp_path / "missing.npy"))
    with pytest.raises(errors.InputError):
        cellsweep.write_frames(str(tmp_path / "frames.txt"), np.zeros((1, 1, 2, 3)))
    with pytest.raises(ValueError, match="shape"):
        cellsweep.write_frames(str(tmp_path / "frames.npy"), np.zeros((1, 2, 3)))
