"""Hard inputs for code of your own: figures that are needles, slivers and flat, and pairs that touch or nearly do.

`plumb.degenerate.strategies` has them as strategies of hypothesis, which is needed for that module alone.
"""
