"""What a particle or body is called in sentences: the name of the file, and the words that the file gives for it.

A file names a particle by a letter or a short word, from which its symbols are formed (P1: r_P1, T_P1). `name:` gives
the words for a sentence ("upper particle"). They travel with the name, so that whatever has the one has the other; in
every other respect the name is an ordinary text.
"""

from __future__ import annotations


class SpokenName(str):
    """The name of a particle or body, with the words for it; a plain text is a name without any."""

    words: str

    def __new__(cls, name: str, words: str = "") -> SpokenName:
        """The name with its words."""
        called = super().__new__(cls, name)
        called.words = words
        return called
