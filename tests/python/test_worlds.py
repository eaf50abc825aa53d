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
