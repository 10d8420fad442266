"""A figure that moves, as data: a program in JavaScript, numbers for the page, and what is written beside them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from lagrange.core.records import record


@record
class Slider:
    """A quantity that the reader can change.

    label   how it is written
    given   whether the file has its value
    angle   whether it turns something
    """

    label: sp.Expr | str
    value: float
    low: float
    high: float
    unit: str = ""
    meaning: str = ""
    given: bool = False
    angle: bool = False
    step: float = 0.0


class UnmovableError(ValueError):
    """A figure cannot move; the message says why, in words for a reader."""


@record
class Still:
    """Why a page does not move."""

    reason: str


@record
class EquilibriumButton:
    """An equilibrium that can be chosen: how it is written, and whether it is stable."""

    relations: tuple[tuple[sp.Expr, sp.Expr], ...]
    stability: str


@record
class MovingFigure:
    """The figure of a page that can be moved.

    code         an object of functions in JavaScript
    data         numbers and names of functions for the page, without any text of the file
    labels       what is written into the figure, by number
    coordinates, parameters  what the reader can change
    reactions    the unknowns in which the reactions are written
    conserved    what is constant along the motion
    equilibria   where it can be at rest
    moves        whether there are equations of motion
    rests        whether there are generalized forces that vanish at rest
    released     whether the file says how the motion begins
    pushed       whether it begins slightly away from an equilibrium
    orbits       whether it begins in a nearly circular orbit, chosen by default
    assumed      what the page takes for functions that the file leaves open
    needed       generalized forces at rest that no position changes: there is no rest unless they vanish
    driven       prescribed motions that the file leaves open, which oscillate
    divided      whether the energy is kinetic and potential; that of a Lagrangian given outright is not
    """

    code: str
    data: Mapping[str, Any]
    labels: tuple[sp.Expr | str, ...]
    coordinates: tuple[Slider, ...]
    parameters: tuple[Slider, ...]
    reactions: tuple[sp.Expr, ...]
    conserved: tuple[tuple[str, sp.Expr], ...]
    equilibria: tuple[EquilibriumButton, ...]
    moves: bool
    rests: bool
    released: bool
    pushed: bool = False
    orbits: bool = False
    assumed: tuple[tuple[sp.Expr, sp.Expr], ...] = ()
    needed: tuple[sp.Expr, ...] = ()
    driven: tuple[sp.Symbol, ...] = ()
    divided: bool = True
