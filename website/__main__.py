"""Writes the sources of the site into a folder: its pages, pictures and configuration."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

from website import site
from website.sources import ROOT


def main(folder: Path) -> int:
    made = site.pages()
    pages = folder / "pages"
    shutil.rmtree(pages, ignore_errors=True)
    for name, text in made.items():
        page = pages / name
        page.parent.mkdir(parents=True, exist_ok=True)
        page.write_text(text, "utf-8")
    (pages / "pictures").mkdir()
    for picture in sorted(path for path in (ROOT / "docs").iterdir() if path.suffix in (".svg", ".png")):
        shutil.copy(picture, pages / "pictures")
    shutil.copytree(ROOT / "website" / "theme", pages / "theme")
    (folder / "mkdocs.yml").write_text(site.configuration(site.navigation(made)), "utf-8")
    links = site.external_links(made)
    (folder / "external-links.txt").write_text("".join(f"{link}\n" for link in links), "utf-8")
    print(f"{len(made)} pages; {len(links)} links elsewhere, listed in {folder / 'external-links.txt'}")
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python -m website FOLDER")
    sys.exit(main(Path(sys.argv[1])))
