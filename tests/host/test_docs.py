"""What the pages point to is there: pictures, files and headings; and no picture that no page shows."""

import re
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).parents[2]
PAGES = [*sorted(REPOSITORY.glob("*.md")), *sorted((REPOSITORY / "docs").rglob("*.md"))]
PICTURES = REPOSITORY / "docs/pictures"
LARGEST_BYTES = 150_000  # a picture is loaded with its page


def linked(page: Path) -> set[Path]:
    """Files of the repository that a page shows or links to."""
    targets = re.findall(r"\]\(([^)#\s]+)(?:#[^)\s]*)?\)", page.read_text(encoding="utf-8"))
    return {(page.parent / target).resolve() for target in targets if "://" not in target}


def headings(page: Path) -> set[str]:
    """As GitHub names them in links."""
    titles = re.findall(r"^#+ (.+)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(REPOSITORY)))
def test_what_a_page_shows_or_links_to_exists(page: Path) -> None:
    assert [target for target in linked(page) if not target.exists()] == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(REPOSITORY)))
def test_the_heading_that_a_page_links_to_exists(page: Path) -> None:
    for target, heading in re.findall(r"\]\(([^)#\s]*\.md)?#([^)\s]+)\)", page.read_text(encoding="utf-8")):
        assert heading in headings((page.parent / target).resolve() if target else page)


def test_every_picture_is_shown_and_small() -> None:
    shown = set().union(*map(linked, PAGES))
    for picture in PICTURES.iterdir():
        assert picture.resolve() in shown
        assert picture.stat().st_size <= LARGEST_BYTES
