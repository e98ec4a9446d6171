"""What verify gives back."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, eq=False)
class Verdict:
    """What ``verify`` has found. True where the claim holds.

    With a field each place has a radius of its own: two points must be the smaller of theirs apart,
    and that is how near a spot must have a point.

    Attributes
    ----------
    holds : bool
        No two points are closer than the radius and, where that was asked, no spot is farther
        from every point than radius + tolerance.
    maximal : bool
        Holds, and with a tolerance of at most 1 % of the radius: nothing is missing.
    kept, covered : bool or None
        The two halves of the claim; covered is None with ``distances_only``, and both are where
        a point lies outside or where none may.
    outside : int or None
        The first point outside the domain: nothing else is then looked at.
    forbidden : int or None
        With a field the first point where the importance is 0: nothing else is then looked at.
    closest_pair, least_distance : tuple of int or None, float
        The indices of the closest two points; how far: infinite for fewer than two. With a field
        the two of the least distance for what they must keep.
    least_limit : float or None
        What these two must keep: the radius, or the smaller of theirs.
    emptiest_spot, emptiest_distance : tuple of float or None, float or None
        The spot of the domain that is farthest from every point; how far. With a field the spot
        that is farthest over its limit, and how far it is from the point that covers it best.
    emptiest_limit : float or None
        How near that spot must have a point.
    radius, tolerance : float
        As claimed; with a field radius is the least of all radii.
    scale : float or None
        With a field the radius where importance is 1, as claimed.
    """

    holds: bool
    maximal: bool
    kept: bool | None
    covered: bool | None
    outside: int | None
    forbidden: int | None
    closest_pair: tuple[int, int] | None
    least_distance: float
    least_limit: float | None
    emptiest_spot: tuple[float, float] | None
    emptiest_distance: float | None
    emptiest_limit: float | None
    radius: float
    tolerance: float
    scale: float | None

    def __bool__(self) -> bool:
        return self.holds
