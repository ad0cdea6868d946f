"""The fonts of formulas: pages fetch small ones, and a sign that none of them has is there too."""

import fonts
import pytest
from browser import draw_all, watched_page
from fontTools.ttLib import TTFont

pytest_plugins = ["browser"]

# a sign as KaTeX sets a letter; zeta stands on no page
SHOW = """(sign) => {
  document.querySelector(".bd-article .katex .mathnormal").textContent = sign;
}"""


def test_ranges_name_each_sign_once():
    assert fonts.ranges({0x41, 0x42, 0x43, 0x3B1}) == "U+41-43,U+3B1-3B1"
    sheet = fonts.faces("@font-face{src:url(fonts/A.woff2) format()}p{}", {0x41})
    whole, small = sheet.split("@font-face")[1:]
    assert whole == "{src:url(fonts/A.woff2) format()}"
    assert "url(fonts/pages-A.woff2?v=" in small
    assert small.endswith("unicode-range:U+41-41}p{}")


@pytest.mark.browser
def test_a_small_font_has_the_signs_of_the_whole_one(site):
    folder = site / "_static" / "katex" / "fonts"
    files = sorted(folder.glob("KaTeX_*.woff2"))
    signs = fonts.signs_of(site)
    for file in files:
        small, whole = TTFont(folder / f"{fonts.SMALL}{file.name}"), TTFont(file)
        assert set(small.getBestCmap()) == set(whole.getBestCmap()) & signs, file.name
        for sign, glyph in small.getBestCmap().items():
            assert small["hmtx"][glyph] == whole["hmtx"][whole.getBestCmap()[sign]], file.name
    assert len(files) == 20


@pytest.mark.browser
def test_a_page_fetches_small_fonts_and_a_whole_one_for_a_sign_of_no_page(chromium, server):
    with watched_page(chromium, server) as (page, watch):
        page.goto(f"{server}frames/frames.html")
        draw_all(page)
        fetched = [url for url in watch.kinds if ".woff2" in url]
        assert len(fetched) > 2
        assert all(f"/{fonts.SMALL}KaTeX_" in url for url in fetched)
        with page.expect_request("**/fonts/KaTeX_Math-Italic.woff2"):
            page.evaluate(SHOW, "ζ")
        assert not watch.errors
