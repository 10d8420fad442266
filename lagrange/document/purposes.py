"""What a paragraph is for in its step, or a few words in their paragraph, as data beside the words.

The full derivation says everything; a page says the same in fewer words. It finds what it shortens by these purposes,
which are given where a sentence is made, and never by its wording: the words may change without a page noticing.
"""

from __future__ import annotations

from enum import Enum, auto


class Purpose(Enum):
    """What words are for; beside each an example."""

    # of paragraphs
    DEFINITIONS = auto()  # For brevity, write
    FRICTION_INSIDE = auto()  # The friction contains N, the reaction of rod, found below.
    FORMS_TOGETHER = auto()  # Taken together, the constraints may imply finite relations
    NOT_EXACT_EITHER = auto()  # (7) is not exact either: ∂a/∂x = 1 ≠ 0 = ∂b/∂y.
    NEXT_PRODUCT = auto()  # With ω now for the form (7),
    NEXT_NOT_INTEGRABLE = auto()  # This does not vanish: (7) is not integrable.
    TIMELESS = auto()  # Time does not appear in (2): virtual displacements satisfy it too,
    DRIFT = auto()  # Possible and virtual displacements differ, because ...
    SOLVING = auto()  # Solving for δx, where x ≠ 0, gives
    FREE = auto()  # δy remains free.
    VIRTUAL = auto()  # In a virtual displacement
    ACTING = auto()  # On P acts its weight.
    LAW = auto()  # Newton's law, mass times acceleration ..., have the components
    COUNT = auto()  # The 2 components ... are 3 equations for 4 unknowns
    ONLY_SUM = auto()  # Only the sum need vanish
    KINEMATICS = auto()  # The acceleration and the rate of change of the angular momentum are
    WRITTEN_OUT = auto()  # Written out, it reads
    PRINCIPLE = auto()  # and d'Alembert's principle (4) reads
    ELIMINATED = auto()  # ψ is eliminated through its velocity.
    RATES = auto()  # Solving (5) for the velocities, and differentiating, gives
    MULTIPLIERS = auto()  # With multipliers instead, nothing is eliminated.
    NOT_SUBSTITUTED = auto()  # The constraint restricts velocities and is not substituted into T before ...
    MAY_PUSH = auto()  # A rod may also push
    CONTACT = auto()  # The floor can only push: it stays in contact as long as N ≥ 0, that is,
    ONLY_PUSHES = auto()  # A support that can only push requires N > 0
    WAVES = auto()  # There are solutions proportional to cos(ω t), with a constant amplitude, where
    RESONANCE = auto()  # The denominator vanishes at a frequency of free oscillations
    IN_TERMS_OF = auto()  # In terms of position and velocity,
    # of paragraphs on what a result says
    IN_SHORT = auto()
    CONSERVED = auto()
    MOMENTUM = auto()  # conserved, linear or angular
    AT_REST = auto()
    SMALL_MOTION = auto()
    LIMIT = auto()
    UNITS = auto()
    # of words in a paragraph
    SUBJECT = auto()  # The accelerations
    VERB = auto()  # is, are
    WHERE = auto()  # , where
    NOUN = auto()  # as generalized coordinates
    CONCLUSION = auto()  # , so the system is
    REASON = auto()  # the end of the first reason
    MOMENTA = auto()  # and its angular momentum about the mass centre
    REACHED = auto()  # The space of reachable configurations has dimension 3. ...
    SUM_AND_MOMENT = auto()  # On the disc act ... In terms of the forces, their sum and their moment are
    NO_TIME = auto()  # Time appears in none of them.
    COMPONENTS = auto()  # the components
    ALONG = auto()  # Along the motion
    THAT_IS = auto()  # , that is,
    LEFT_SIDES = auto()  # the colon after `N times the left side of (3)`
    EVERY_COORDINATE = auto()  # so for every coordinate
    GIVEN_VALUES = auto()  # with the given values
    AFTERMATH = auto()  # : at resonance there is no steady state


class Phrase(str):
    """Words of a paragraph that have a purpose of their own in it.

    instead  what a page says in their place where it says less
    """

    purpose: Purpose | None
    instead: str

    def __new__(cls, words: str, purpose: Purpose | None = None, instead: str = "") -> Phrase:
        """The words with their purpose."""
        phrase = super().__new__(cls, words)
        phrase.purpose, phrase.instead = purpose, instead
        return phrase
