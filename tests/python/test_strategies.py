"""Are the strategies of hypothesis hard, and do the answers keep their laws on what they give?"""

import doctest
import math
from collections import Counter
from fractions import Fraction

import numpy as np
import pytest

import plumb

hypothesis = pytest.importorskip("hypothesis")

from hypothesis import HealthCheck, find, given, seed, settings  # noqa: E402

from plumb.degenerate import strategies  # noqa: E402
from test_signs import SEED, dot, sub  # noqa: E402

CLASSES = [getattr(plumb, name) for name in plumb._plumb._generated_classes]
QUIET = settings(max_examples=60, deadline=None, database=None, suppress_health_check=list(HealthCheck))


def test_doctests():
    results = doctest.testmod(strategies)
    assert results.attempted > 3 and results.failed == 0


@pytest.mark.parametrize("kind", CLASSES, ids=lambda c: c.__name__)
def test_figures_of_every_class(kind):
    seen = []

    @seed(SEED)
    @QUIET
    @given(strategies.figures(kind))
    def look(figure):
        assert type(figure) is kind and eval(repr(figure), vars(plumb)) == figure
        seen.append(figure)

    look()
    assert len(set(seen)) > 20


def test_all_classes_but_caps():
    assert {c.__name__ for c in plumb.Figure.__subclasses__()} - {c.__name__ for c in CLASSES} == {"SphericalCap3"}


@pytest.mark.parametrize("a, b", [(plumb.Triangle3, plumb.Triangle3), (plumb.Aabb3, plumb.Sphere3),
                                  (plumb.Segment2, plumb.Circle2), (plumb.Tetrahedron3, plumb.Obb3)])
def test_pairs_touch_overlap_and_miss(a, b):
    relations = Counter()

    @seed(SEED)
    @settings(QUIET, max_examples=300)
    @given(strategies.pairs(a, b))
    def look(pair):
        relation = plumb.relate(*pair)
        relations[relation] += 1
        assert plumb.relate(pair[1], pair[0]) == relation
        assert (plumb.distance(*pair, exact=True).square <= plumb.distance(*pair, exact=True).inset ** 2) == \
            (relation != plumb.Relation.disjoint)

    look()
    assert relations[plumb.Relation.touching] > 10 and len(relations) == 3, relations


def test_points_are_those_of_fractions():
    @seed(SEED)
    @settings(QUIET, max_examples=200)
    @given(strategies.points(3), strategies.points(3))
    def look(p, q):
        off = sub(list(map(Fraction, p.tolist())), list(map(Fraction, q.tolist())))
        assert plumb.squared_distance(p, q) == dot(off, off)

    look()


def test_shrinks_to_small_integers():
    least = find(strategies.figures(plumb.Sphere3), lambda s: s.radius >= 1, settings=QUIET)
    assert np.abs(least.center).max() <= 1 and least.radius <= 4 and math.floor(least.radius) == least.radius


@pytest.mark.parametrize("make", [lambda: strategies.figures(plumb.SphericalCap3), lambda: strategies.figures("Sphere3"),
                                  lambda: strategies.pairs(plumb.Point2, plumb.Point3), lambda: strategies.points(4)])
def test_what_is_refused(make):
    with pytest.raises(ValueError):
        make()
