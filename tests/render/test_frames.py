"""Frames of a talk: balanced, with labels of their own, compiled by a real TeX without a complaint."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from lagrange.render import frames
from lagrange.render.tex_layout import Vectors
from tests.support.sample_derivations import pendulum
from tests.support.shared import reported
from tests.support.tex import faults_of_tex, needs_tex


def talk(*names: str) -> str:
    found = [reported(name) for name in names]
    return frames.render([(r.derivation, r.notation) for r in found])


def has_beamer() -> bool:
    found = shutil.which("kpsewhich")
    return (
        found is not None
        and subprocess.run([found, "-q", "beamer.cls"], capture_output=True, timeout=60).returncode == 0
    )


def test_every_step_is_a_frame() -> None:
    text = talk("ex11-ideal-pendulum")
    assert text.count(r"\begin{frame}") == text.count(r"\end{frame}")
    titles = re.findall(r"\\begin\{frame\}\[allowframebreaks\]\{(.*)\}", text)
    assert titles[:2] == ["Ideal pendulum", "The system"]
    open_ = [s.title for s in reported("ex11-ideal-pendulum").derivation.page if s.title and not s.folded]
    assert len(titles) <= len(open_) + 1
    assert r"\boxed" in text.split(r"\end{frame}")[0] or r"\fbox" in text.split(r"\end{frame}")[0]


def test_frames_alone() -> None:
    derivation, notation = pendulum()
    text = frames.render([(derivation, notation), (derivation, notation)], fragment=True, vectors=Vectors.ARROW)
    assert r"\documentclass" not in text.split("\n", 3)[3]
    labels = re.findall(r"\\label\{(.*?)\}", text)
    assert labels
    assert len(set(labels)) == len(labels)
    assert r"\mathbf" not in text


@needs_tex
@pytest.mark.skipif(not has_beamer(), reason="beamer is not installed")
@pytest.mark.parametrize("names", [("ex11-ideal-pendulum", "leaving-a-sphere")])
def test_a_talk_compiles(names: tuple[str, ...], tmp_path: Path) -> None:
    assert faults_of_tex(talk(*names), tmp_path) == []
