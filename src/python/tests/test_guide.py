"""The chapter on Python: what it shows is what comes out."""

import doctest
import re

import chattercheck as cc

from conftest import ROOT


def test_the_chapter_is_true() -> None:
    text = (ROOT / "src/guide/python.md").read_text()
    shown = re.sub(r"^```.*$", "", text, flags=re.MULTILINE)
    test = doctest.DocTestParser().get_doctest(shown, {}, "python.md", "src/guide/python.md", 0)
    assert len(test.examples) > 15
    failed = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE).run(test)
    assert failed.failed == 0


def test_the_version_is_that_of_the_harness() -> None:
    root = re.search(r'\[workspace.package\]\nversion = "(.*)"', (ROOT / "Cargo.toml").read_text())
    assert root is not None and cc.__version__ == root.group(1)
