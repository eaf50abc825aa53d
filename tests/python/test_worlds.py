"""Worlds: pairs, contacts, rays, distances and motions as the questions of two figures tell them."""

import random

import numpy as np
import pytest

import plumb


def a_figure(rng):
    at = [float(rng.randint(-3, 3)) for _ in range(3)]
    kind = rng.randrange(4)
    if kind == 0:
        return plumb.Aabb3(at, [x + rng.randint(1, 2) for x in at])
    if kind == 1:
        return plumb.Sphere3(at, float(rng.randint(1, 2)))
    if kind == 2:
        return plumb.Capsule3(at, [at[0] + 1, at[1], at[2] + 1], 0.5)
    return plumb.Triangle3(at, [at[0] + 1, at[1], at[2]], [at[0], at[1] + 2, at[2] + 1])


def a_turn(rng):
    return rng.choice([(1, 0, 0, 0), (1, 0, 0, 1), (2, 1, -1, 3)])


@pytest.mark.parametrize("seed", range(6))
def test_frames_are_those_of_each_pair(seed):
    rng = random.Random(seed)
    world = plumb.CollisionWorld(contacts=True)
    bodies = {}
    for n in range(24):
        figure = a_figure(rng)
        bodies[world.add(figure, user_id=n)] = figure
    before = set()
    met = 0
    for _ in range(5):
        for body in list(bodies):
            if rng.random() < 0.3:
                turn, to = a_turn(rng), [float(rng.randint(-2, 2)) for _ in range(3)]
                world.move(body, turn=turn, translation=to)
                bodies[body] = bodies[body].posed(turn=turn, translation=to)
        order = sorted(bodies, key=world.user_id)
        now = {(a, b) for i, a in enumerate(order) for b in order[i + 1:] if plumb.intersects(bodies[a], bodies[b])}
        events = world.commit()
        assert {tuple(p) for p in events.begun.tolist()} == now - before
        assert {tuple(p) for p in events.kept.tolist()} == now & before
        assert {tuple(p) for p in events.ended.tolist()} == before - now
        pairs, overlapping = world.pairs()
        for (a, b), overlaps in zip(pairs.tolist(), overlapping):
            relation = plumb.relate(bodies[a], bodies[b])
            assert (relation == plumb.Relation.overlapping) == overlaps
        for c in world.contacts():
            expected = plumb.contact(bodies[c.a], bodies[c.b])
            assert c.contact.distance == expected.distance and len(c.contact.corners) == len(expected.corners)
        assert len(world.contacts()) == len(now)
        assert world.check() == [] and world.check(samples=3) == []
        before = now
        met += len(now)
    assert met > 30


def test_questions_of_all_bodies():
    world = plumb.CollisionWorld()
    ball = world.add(plumb.Sphere3([0, 0, 0], 1), user_id=1)
    rock = world.add(plumb.Mesh([[5, -1, -1], [5, 1, -1], [5, 0, 2]], [[0, 1, 2]]), user_id=2, group=2)
    both = world.add([plumb.Aabb3([0, 0, 5], [1, 1, 6]), plumb.Sphere3([9, 9, 9], 1)], user_id=3,
                     translation=[0, 0, 1])
    hit = world.first_hit(plumb.Ray3([-4, 0, 0], [1, 0, 0]))
    assert (hit.body, hit.t) == (ball, 3.0) and hit.point.tolist() == [-1, 0, 0]
    assert world.first_hit(plumb.Ray3([-4, 0, 0], [1, 0, 0]), mask=2).body == rock
    assert world.first_hit(plumb.Ray3([-4, 9, 0], [-1, 0, 0])) is None
    assert [n.body for n in world.nearest([0, 0, 3], k=2)] == [ball, both]
    assert [n.body for n in world.within([0, 0, 3], 2.0)] == [ball]
    assert [(p.a, p.b, p.distance) for p in world.nearest_pairs(2)] == [(ball, rock, 4.0), (ball, both, 5.0)]
    assert world.nearest_pairs(within=3.9) == []
    assert world.overlaps(plumb.Aabb3([9, 9, 9], [9, 9, 9])).tolist() == [both]
    cast = world.first_contact(plumb.Sphere3([0, 0, 3], 1), [0, 0, 10])
    assert (cast.body, cast.part) == (both, (0, 0))
    assert cast.contact.time == pytest.approx(0.2)
    impact, = world.first_contacts({ball: [8, 0, 0]})
    assert (impact.a, impact.b, impact.rank, impact.contact.time) == (ball, rock, 0, 0.5)


def test_what_turns_does_not_tunnel():
    world = plumb.CollisionWorld()
    needle = world.add(plumb.Segment3([1, 0, 0], [4, 0, 0]), user_id=1)
    blade = world.add(plumb.Triangle3([0, 2, -1], [0, 2, 1], [0, 3, 0]), user_id=2)
    span, = world.first_contact_spans({needle: ((0, 0, 0, 1), None)})
    assert (span.a, span.b, span.is_certain) == (needle, blade, True)
    assert span.begin <= 0.5 <= span.end <= span.begin + 2**-12
    assert world.first_contact_spans({needle: ((1, 0, 0, -1), None)}, resolution=2**-6) == []
    with pytest.raises(TypeError, match="a turn and a translation"):
        world.first_contact_spans({needle: (1, 0, 0, -1)})


def test_what_is_no_body_is_refused_by_name():
    world = plumb.CollisionWorld()
    body = world.add(plumb.Sphere3([0, 0, 0], 1), user_id=7)
    with pytest.raises(ValueError, match="translation"):
        world.move(body, translation=[float("nan"), 0, 0])
    with pytest.raises(ValueError, match="turn"):
        world.move(body, turn=[0, 0, 0, 0])
    with pytest.raises(ValueError, match="body 8"):
        world.add(plumb.Plane3([0, 0, 1], 0), user_id=8)
    with pytest.raises(ValueError, match="keeps none"):
        world.contacts()
    with pytest.raises(TypeError):
        world.first_hit(plumb.Sphere3([0, 0, 0], 1))
    assert body in world and len(world) == 1
    world.remove(body)
    assert body not in world and len(world) == 0
    with pytest.raises(ValueError, match="was it removed"):
        world.remove(body)
    assert isinstance(body, int) and np.uint64(body) == body


def stones(seed, options, contacts=False):
    """A world of lumps under turns, near to one another, some of them compounds."""
    rng = random.Random(seed)
    world = plumb.CollisionWorld(contacts=contacts)
    for n in range(14):
        hull = plumb.ConvexHull([[rng.randint(-9, 9) for _ in range(3)] for _ in range(16)])
        lump = plumb.Mesh(hull.points, hull.simplices)
        body = [lump, plumb.Sphere3([0, 0, 9], 3)] if n % 4 == 0 else lump
        turn, at = [rng.randint(-2, 2) or 1 for _ in range(4)], [10.0 * rng.randint(-1, 1) for _ in range(3)]
        world.add(body, user_id=n, turn=turn, translation=at, **options(n))
    return world


@pytest.mark.parametrize("seed", range(3))
def test_proxies_change_no_answer(seed):
    plain, planned = stones(seed, lambda n: {}), stones(seed, lambda n: {})
    given = stones(seed, lambda n: {"proxy": ("none", "sphere", "box", "hull")[n % 4]})
    scene = planned.plan()
    assert scene.questions_with < scene.questions_without and isinstance(scene.index, str)
    assert sum(b.saved > 0 for b in scene.bodies) > 0
    planned.adopt(scene)
    for b in scene.bodies:
        assert planned.proxy(b.body) == b.proxy and (b.proxy == "none") == (b.saved == 0)
    worlds = plain, planned, given
    for world in worlds:
        world.commit()
    expected = [x.tolist() for x in plain.pairs()]
    assert 0 < len(expected[0]) < 14 * 13 // 2
    for world in worlds[1:]:
        assert [x.tolist() for x in world.pairs()] == expected and world.check() == []
        assert world.nearest_pairs(9) == plain.nearest_pairs(9)
        assert world.nearest([30, 0, 0], k=5) == plain.nearest([30, 0, 0], k=5)
    assert plumb.CollisionWorld().plan() == ([], 0, 0, None)


def test_what_no_proxy_is_said_of():
    world = plumb.CollisionWorld()
    flat = world.add(plumb.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]), user_id=5)
    with pytest.raises(ValueError, match="proxy is 'ball'; give 'none', 'sphere', 'box' or 'hull'"):
        world.set_proxy(flat, "ball")
    with pytest.raises(ValueError, match="body 5"):
        world.set_proxy(flat, "hull")
    with pytest.raises(ValueError, match="proxy is 'cap'"):
        world.add(plumb.Sphere3([0, 0, 0], 1), proxy="cap")
    assert world.proxy(flat) == "none" and len(world) == 1
    with pytest.raises(AttributeError):
        world.adopt(3)


def test_a_filter_of_the_callers():
    world = plumb.CollisionWorld()
    bodies = [world.add(plumb.Sphere3([n / 4, 0, 0], 1), user_id=n) for n in range(6)]
    asked = []

    def keeps(a, b):
        asked.append((world.user_id(a), world.user_id(b)))
        return (world.user_id(a) + world.user_id(b)) % 2

    world.set_filter(keeps)
    begun = world.commit().begun.tolist()
    assert asked == [(i, j) for i in range(6) for j in range(i + 1, 6)]
    assert begun == [[bodies[i], bodies[j]] for i, j in asked if (i + j) % 2]
    assert world.check() == []

    def fails(a, b):
        raise KeyError("of the filter")

    world.set_filter(fails)
    with pytest.raises(KeyError, match="of the filter"):
        world.commit()
    assert len(world.pairs()[0]) == len(begun)  # as it was
    world.set_filter(None)
    assert len(world.commit().begun) == 15 - len(begun)
    with pytest.raises(TypeError, match="no function"):
        world.set_filter(3)


@pytest.mark.parametrize("seed", range(4))
def test_casts_and_hits_are_those_of_each_body(seed):
    rng = random.Random(seed)
    world = plumb.CollisionWorld()
    bodies = {world.add(figure, user_id=n): figure for n, figure in enumerate(a_figure(rng) for _ in range(12))}
    moved = 0
    for _ in range(12):
        ball = plumb.Sphere3([float(rng.randint(-8, 8)) for _ in range(3)], 0.5)
        by = [rng.randint(-2, 2) - 2 * x for x in ball.center]  # past the middle
        expected = {body: plumb.first_contact(ball, figure, by=by) for body, figure in bodies.items()}
        expected = {body: c.time for body, c in expected.items() if c is not None}
        casts = world.contacts_along(ball, by)
        assert {c.body: c.contact.time for c in casts} == expected
        assert [c.contact.time for c in casts] == sorted(expected.values())
        first = world.first_contact(ball, by)
        assert first == (casts[0] if casts else None)
        spans = {s.body: s for s in world.contact_spans_along(ball, translation=by)}
        assert set(expected) <= set(spans)
        for body, time in expected.items():
            span = spans[body]  # the first in which it is not ruled out, which a near miss may be
            assert span.begin <= time and span.end <= span.begin + 2**-12 and (time <= span.end or not span.is_certain)
        moved += len(expected)
        ray = plumb.Ray3(ball.center, by if any(by) else [1, 0, 0])
        hits = {body: plumb.first_hit(ray, figure) for body, figure in bodies.items()}
        told = world.hits(ray)
        assert {h.body: h.t for h in told} == {body: h.t for body, h in hits.items() if h is not None}
        assert [h.t for h in told] == sorted(h.t for h in told) and world.any_hit(ray) == bool(told)
    assert moved > 10


def test_a_cast_that_turns_meets_what_its_ends_do_not():
    world = plumb.CollisionWorld()
    post = world.add(plumb.Capsule3([0, 2, -1], [0, 2, 1], 0.25), user_id=1)
    world.add(plumb.Sphere3([0, -9, 0], 1), user_id=2)
    needle = plumb.Segment3([1, 0, 0], [4, 0, 0])
    span, = world.contact_spans_along(needle, turn=(0, 0, 0, 1), resolution=2**-8)  # half a turn about z
    assert span.body == post and span.is_certain and 0 < span.begin < 0.5 and span.end - span.begin <= 2**-8
    assert world.contact_spans_along(needle, turn=(0, 0, 0, 1), mask=2) == []
    assert world.first_contact(needle, [-5, 0, 0]) is None
    with pytest.raises(ValueError, match="resolution"):
        world.contact_spans_along(needle, turn=(0, 0, 0, 1), resolution=0)


def test_corners_begin_and_end_by_name():
    world = plumb.CollisionWorld(contacts=True)
    floor = world.add(plumb.Aabb3([-9, -9, -1], [9, 9, 0]), user_id=1)
    crate = world.add(plumb.Aabb3([0, 0, 0], [1, 1, 1]), user_id=2)
    names = set()
    for at in ([0, 0, 0], [3, 0, 0], [8.5, 0, 0], [8.5, 0, 1], [0, 0, 0]):
        world.move(crate, translation=at)
        world.commit()
        events = world.corner_events()
        now = {(c.a, c.b, c.part_a, c.part_b, corner.id) for c in world.contacts() for corner in c.contact.corners}
        assert {tuple(c) for c in events.begun} == now - names and {tuple(c) for c in events.ended} == names - now
        assert all((c.a, c.b) == (floor, crate) for c in events.begun)
        names = now
    assert len(names) == 4
    with pytest.raises(ValueError, match="keeps none"):
        plumb.CollisionWorld().corner_events()
