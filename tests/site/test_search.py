"""The search: what must come first, results while typing, and by keyboard."""

import tomllib
from collections import Counter

import pytest
import search
from browser import watched_page

pytest_plugins = ["browser"]

# What a reader types, and the page or section that must come first.
ARM, EULER, FRAMES = "elbow_arm/elbow_arm", "euler/euler", "frames/frames"
DRIVE, WHEELS = "differential_drive/differential_drive", "wheels/wheels"
ODOMETRY, PLANAR, TERM = "odometry/odometry", "planar_arm/planar_arm", "glossary#term-"
FIRST = {
    # a chapter by a word of its title
    "inverse kinematics": ARM,
    "omni": WHEELS,
    "encoder": ODOMETRY,
    # the field's words
    "law of cosines": f"{ARM}#the-triangle",
    "gimbal lock": f"{TERM}gimbal-lock",
    "homogeneous transform": f"{FRAMES}#a-pose-as-a-matrix",
    "ICR": f"{DRIVE}#where-the-icr-goes",
    "Ackermann": "bicycle/bicycle#and-back-one-steering-wheel-two-angles",
    "covariance": f"{ODOMETRY}#many-slips-are-many-doors",
    "manipulability": f"{PLANAR}#all-at-once",
    # symbols
    "φ": "notation#wheel-constraints-and-the-omni-robot",
    # functions, and errors
    "arc_step": "api#robokin.motion.arc_step",
    "ValueError": f"{FRAMES}#where-it-fails",
    # mistakes and exercises
    "M8": f"{EULER}#M8",
    "half the wheel distance": f"{DRIVE}#M12",
    "planar-arm-3": f"{PLANAR}#planar-arm-3",
    # slips
    "jacobain": f"{TERM}Jacobian",
    "differental drive": DRIVE,
    # Persian, with the Arabic kaf and ya
    "ژاكوبين": f"{TERM}Jacobian",
    # teachers and students
    "Moodle": "teaching#in-moodle",
    "offline": "index#for-students",
}
ASK = "(q) => siteSearch.ask(q).slice(0, 1).map(({page, at}) => at ? `${page}#${at}` : page)[0]"


@pytest.mark.browser
def test_what_comes_first(site, server, chromium):
    """Twenty questions, over http."""
    with watched_page(chromium, server) as (page, watch):
        page.goto(server + "search.html?q=wheel")
        page.wait_for_selector(".site-results li")
        found = {words: page.evaluate(ASK, words) for words in FIRST}
        assert not watch.errors + watch.strangers
    assert found == FIRST


@pytest.mark.browser
def test_a_result_leads_to_its_section(site, chromium):
    """From disk: typed in the dialog, chosen with the arrows."""
    home = site.as_uri() + "/"
    with watched_page(chromium, home, 390) as (page, watch):
        page.goto(home + "index.html")
        page.locator(".search-button__button:visible").click()
        page.keyboard.type("rolling constr")
        results = page.locator("dialog .site-results li")
        results.first.filter(has_text="How fast must it turn").wait_for()
        assert results.first.locator("mark").first.text_content().lower() == "rolling"
        page.keyboard.press("ArrowDown")
        page.keyboard.press("Enter")
        page.wait_for_url("**/wheels.html#how-fast-must-it-turn")
        assert not watch.errors + watch.strangers


def test_formulas_are_read_as_a_reader_sees_them(site):
    data = (site / "_static" / "search-data.js").read_text("utf-8")
    assert "symbol=" not in data  # which marks a symbol in TeX


def test_words_lead_to_one_place_each():
    pages = tomllib.loads(search.WORDS.read_text("utf-8"))
    listed = [words.split(", ") for sections in pages.values() for words in sections.values()]
    counts = Counter(words for each in listed for words in each)
    assert not [words for words, count in counts.items() if count > 1 or words != words.lower()]


def test_words_for_what_is_no_section_are_refused():
    entry = {"page": "wheels", "at": "castor", "title": "Castors"}
    assert search.add_words([dict(entry)], {"wheels": {"castor": "trolley"}}) == [
        entry | {"also": "trolley"}
    ]
    with pytest.raises(ValueError, match=r"search_words\.toml .* no section: wheels#caster"):
        search.add_words([entry], {"wheels": {"caster": "trolley"}})
