"""Folders of the project."""

from __future__ import annotations

from pathlib import Path

ROOT = Path(__file__).parents[2]
PROBLEMS = ROOT / "problems"
SYSTEM_FILES = ROOT / "tests" / "truth" / "systems"
"""Problems of textbooks that are not shipped, for the second routes."""
