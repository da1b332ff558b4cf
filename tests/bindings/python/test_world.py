"""Worlds from Python: the pairs, changes and answers of NumPy's brute force."""

import threading

import brute_force
import cellsweep
import numpy as np
import pytest
from cellsweep import errors


@pytest.fixture
def rng():
    return np.random.default_rng(2)


def rows_of(pairs):
    return {tuple(pair) for pair in pairs.tolist()}


@pytest.mark.parametrize("engine", [name for name, _ in cellsweep.engines()])
def test_a_world_follows_its_bodies(rng, engine):
    world = cellsweep.World(engine)
    assert world.engine == engine and world.capacity > 1000
    ids = np.sort(rng.choice(2**32, 200, replace=False)).astype(np.uint32)
    boxes = brute_force.random_boxes(rng, 200)
    world.insert(ids, boxes)
    held = set()
    for step in range(6):
        began, ended = world.update()
        expected = rows_of(ids[brute_force.pairs(boxes)])
        assert rows_of(began) == expected - held and rows_of(ended) == held - expected
        np.testing.assert_array_equal(world.pairs, sorted(expected))
        np.testing.assert_array_equal(world.boxes(ids), boxes)
        held = expected
        some = rng.choice(len(ids), 30, replace=False)
        boxes[some] = brute_force.random_boxes(rng, 30)
        world.move(ids[some], boxes[some])
        if step == 3:
            world.remove(ids[:20])
            ids, boxes = ids[20:], boxes[20:]
    assert len(world) == 180 and ids[0] in world and 3 not in world


def test_ids_are_handed_out(rng):
    world = cellsweep.World()
    assert world.add(np.zeros((3, 2, 3))).tolist() == [0, 1, 2]
    world.update()
    world.remove([1])
    world.update()
    assert world.add(np.ones((1, 2, 3))).tolist() == [1]
    assert world.add(np.zeros((0, 2, 3))).tolist() == []


def test_filters_decide_who_meets(rng):
    world = cellsweep.World()
    ids = world.add(np.zeros((4, 2, 3)), category=[1, 1, 2, 4], mask=[7, 7, 1, 3], static=[True, True, False, False])
    world.update()
    assert world.pairs.tolist() == [[0, 2], [0, 3], [1, 2], [1, 3]]
    categories, masks, are_static = world.filters(ids)
    assert categories.tolist() == [1, 1, 2, 4] and masks.tolist() == [7, 7, 1, 3]
    assert are_static.dtype == np.bool_ and are_static.tolist() == [True, True, False, False]
    world.set_filters([0, 1], static=False)
    began, ended = world.update()
    assert began.tolist() == [[0, 1]] and len(ended) == 0
    assert world.filters([1])[1].tolist() == [7], "what is not named stays"
    world.set_filters(ids, mask=0)
    assert len(world.update().ended) == 5


def test_doubles_and_flat_boxes_touch_outward():
    world = cellsweep.World()
    world.add(np.array([[[0.0, 0.0], [1.0, 1.0]], [[1.0 + 1e-12, 0.0], [2.0, 1.0]], [[3.0, 0.0], [4.0, 1.0]]]))
    world.update()
    assert world.pairs.tolist() == [[0, 1]]
    assert world.boxes([1])[0].tolist() == [[1, 0, 0], [2, 1, 0]]


def test_a_call_that_fails_changes_nothing(rng):
    world = cellsweep.World(max_pairs=10)
    world.insert([1, 2, 3], np.zeros((3, 2, 3)))
    world.update()
    bad = np.zeros((3, 2, 3))
    bad[1, 0, 0] = np.inf
    for call, error, rows in [
        (lambda: world.insert([9, 2, 1], np.zeros((3, 2, 3))), errors.DuplicateBodyError, [1, 2]),
        (lambda: world.insert([8, 9, 8], np.zeros((3, 2, 3))), errors.DuplicateBodyError, [2]),
        (lambda: world.insert([7, 8, 9], bad), errors.InvalidBoxError, [1]),
        (lambda: world.move([1, 5], np.zeros((2, 2, 3))), errors.UnknownBodyError, [1]),
        (lambda: world.remove([5]), errors.UnknownBodyError, [0]),
        (lambda: world.set_filters([1, 5], mask=3), errors.UnknownBodyError, [1]),
        (lambda: world.boxes([1, 6]), errors.UnknownBodyError, [1]),
        (lambda: world.filters([6]), errors.UnknownBodyError, [0]),
        (lambda: world.pairs_of([6]), errors.UnknownBodyError, [0]),
        (lambda: world.insert([7], np.zeros((2, 2, 3))), errors.InputError, []),
    ]:
        with pytest.raises(error) as raised:
            call()
        assert raised.value.rows == rows, raised.value
    for wrong, error in [([-1], OverflowError), ([2**32], OverflowError), ([1.5], TypeError), ([[1]], ValueError),
                         (np.array([2**64 - 1], np.uint64), OverflowError), ("1", TypeError)]:
        with pytest.raises(error):
            world.insert(wrong, np.zeros((1, 2, 3)))
    with pytest.raises(ValueError, match="category"):
        world.add(np.zeros((3, 2, 3)), category=[1, 2])
    with pytest.raises(OverflowError, match="mask"):
        world.add(np.zeros((3, 2, 3)), mask=2**32)
    assert len(world) == 3 and rows_of(world.pairs) == {(1, 2), (1, 3), (2, 3)}
    world.add(np.zeros((3, 2, 3)))
    with pytest.raises(errors.CapacityError):
        world.update()
    assert rows_of(world.pairs) == {(1, 2), (1, 3), (2, 3)}
    assert len(world.update.__doc__) > 50


def test_options_are_refused_by_name():
    with pytest.raises(errors.OptionError, match="nope"):
        cellsweep.World(nope=1)
    with pytest.raises(errors.OptionError, match="threads"):
        cellsweep.World(threads=-1)
    with pytest.raises(errors.OptionError, match="streem"):
        cellsweep.World("streem")


def test_questions_are_answered_as_by_brute_force(rng):
    boxes = brute_force.random_boxes(rng, 400)
    ids = np.arange(400, dtype=np.uint32) * 3
    world = cellsweep.World()
    world.insert(ids, boxes)
    world.update()
    asked = brute_force.random_boxes(rng, 40)
    met = brute_force.overlaps(asked, boxes)
    answers = world.find_overlaps(asked)
    assert answers.values is None and answers.counts.sum() == len(answers.bodies)
    distances = brute_force.distances(asked, boxes)
    within = world.find_within(asked, 0.125)
    nearest = world.find_nearest(asked, 7)
    for i in range(40):
        assert answers.of(i).tolist() == ids[met[i]].tolist()
        order = np.lexsort((ids, distances[i]))
        near = order[distances[i][order] <= 0.125]
        assert within.of(i).tolist() == ids[near].tolist()
        assert within.values[within.first[i] : within.first[i + 1]].tolist() == distances[i][near].tolist()
        assert nearest.of(i).tolist() == ids[order[:7]].tolist()
    assert (answers.questions[1:] >= answers.questions[:-1]).all()
    assert world.any_overlaps(asked).tolist() == met.any(axis=1).tolist()
    some = [3, 30, 300]
    assert rows_of(world.pairs_of(some)) == {p for p in rows_of(world.pairs) if set(p) & set(some)}


def test_rays_meet_what_they_meet(rng):
    boxes = brute_force.random_boxes(rng, 300)
    world = cellsweep.World()
    ids = world.add(boxes)
    world.update()
    world.prepare_queries()
    start = np.concatenate([rng.random((50, 1)) * -1, rng.random((50, 2))], axis=1).astype(np.float32)
    # Along x: in y and z a box is met or not, and the time is the way to its minimum.
    hit = np.all((boxes[None, :, 0, 1:] <= start[:, None, 1:]) & (start[:, None, 1:] <= boxes[None, :, 1, 1:]), axis=2)
    times = boxes[None, :, 0, 0].astype(np.float64) - start[:, None, 0]
    found = world.find_touches(start, [1, 0, 0])
    first, when = world.first_touches(start, [1, 0, 0])
    for i in range(50):
        order = [k for k in np.lexsort((ids, times[i])) if hit[i, k]]
        assert found.of(i).tolist() == ids[order].tolist()
        assert found.values[found.first[i] : found.first[i + 1]].tolist() == times[i][order].tolist()
        assert first[i] == (order[0] if order else -1)
        assert when[i] == times[i][order[0]] if order else np.isnan(when[i])
    assert world.any_touches(start, [1, 0, 0]).tolist() == hit.any(axis=1).tolist()
    assert not world.any_touches(start, np.broadcast_to([-1.0, 0, 0], (50, 3))).any()
    assert world.any_touches(start, [1, 0, 0], end=0).sum() == 0


def test_questions_take_filters_and_refuse_nonsense():
    world = cellsweep.World()
    world.add(np.zeros((3, 2, 3)), category=[1, 2, 4])
    world.update()
    assert world.find_overlaps([0.0, 0, 0], mask=6).of(0).tolist() == [1, 2]
    with pytest.raises(errors.InputError):
        world.find_overlaps([0.0, 0, 0], distance=-1)
    with pytest.raises(errors.InputError):
        world.find_touches([0.0, 0, 0], [0, 0, 0])
    with pytest.raises(errors.InvalidBoxError):
        world.find_nearest([np.nan, 0, 0])
    with pytest.raises(ValueError, match="direction"):
        world.find_touches([0.0, 0, 0], [1.0])
    with pytest.raises(ValueError, match="distance"):
        world.find_within([0.0, 0, 0], [1.0, 2.0])


def test_history_adds_changes_up():
    world, history = cellsweep.World(), cellsweep.PairHistory(1000)
    ids = world.add(np.zeros((4, 2, 3)))
    for step in range(4):
        world.move(ids[step:], np.full((4 - step, 2, 3), 10.0 * step))
        changes = world.update()
        history.record(world.statistics["updates"], changes)
    began, ended = history.since(1)
    assert len(began) == 0 and len(ended) == 6
    with pytest.raises(errors.InputError):
        history.since(9)


def test_threads_share_a_world(rng):
    boxes = brute_force.random_boxes(rng, 2000, edge=0.05)
    world = cellsweep.World()
    ids = world.add(boxes)
    world.update()
    expected = cellsweep.count_pairs(boxes)
    failures = []

    def ask():
        for _ in range(30):
            counts = world.find_overlaps(boxes[:100]).counts
            if (counts < 1).any() or len(world.pairs) != expected:
                failures.append(counts)

    def update():
        for _ in range(30):
            world.move(ids, boxes)
            world.update()

    threads = [threading.Thread(target=target) for target in (ask, ask, ask, update, update)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures


def test_other_threads_run_during_a_search(rng):
    """The interpreter's lock is released: a loop goes on turning while a long search runs."""
    boxes = brute_force.random_boxes(rng, 300_000, edge=0.02)
    turns, done = [0], threading.Event()

    def turn():
        while not done.is_set():
            turns[0] += 1

    thread = threading.Thread(target=turn)
    thread.start()
    before = turns[0]
    cellsweep.count_pairs(boxes, threads=1)
    during = turns[0] - before
    done.set()
    thread.join()
    assert during > 0


def test_a_view_of_stream_encloses_its_bodies(rng):
    boxes = brute_force.random_boxes(rng, 5000, edge=0.02)
    world = cellsweep.World()
    ids = world.add(boxes)
    world.update()
    boxes += np.float32(0.001)
    world.move(ids, boxes)
    world.update()
    fat, cells = world.stream_view()
    assert fat.shape == (5000, 2, 3) and len(cells) > 8
    assert (fat[:, 0].min(axis=0) <= boxes[:, 0].min(axis=0)).all()
    assert (fat[:, 1].max(axis=0) >= boxes[:, 1].max(axis=0)).all()
    assert cellsweep.World("oracle").stream_view() is None


def test_statistics_and_words():
    world = cellsweep.World(threads=2)
    world.add(np.zeros((3, 2, 3)))
    world.update()
    of = world.statistics
    assert of["updates"] == 1 and of["bytes"] > 0 and of["milliseconds"] and of["counters"]
    assert repr(world) == "<cellsweep.World: 3 bodies, engine 'stream'>"
    for name in cellsweep.__all__:
        assert getattr(cellsweep, name).__doc__, name
