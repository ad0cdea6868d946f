"""The search: what must come first, results while typing, and by keyboard."""

import pytest
from browser import watched_page

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

# What a reader types, and the page and section that must come first.
FIRST = {
    "law of cosines": "elbow_arm/elbow_arm#first-way-three-angles",
    "atan2": "elbow_arm/elbow_arm#second-way-a-cosine-the-rest-with-atan2",
    "M1": "elbow_arm/elbow_arm#M1",
    "workspace": "glossary#term-workspace-reachable-workspace",
    "gimbal lock": "glossary#term-gimbal-lock",
    "M8": "euler/euler#M8",
    "euler-3": "euler/euler#euler-3",
    "quaternion": "euler/euler",
    "camera": "frames/frames#a-camera-that-looks-down",
    "M12": "differential_drive/differential_drive#M12",
    "ICR": "glossary#term-ICR-instantaneous-centre-of-rotation",
    "lane": "bicycle/bicycle#the-lane",
    "Ackermann": "wheels/wheels#a-car-s-front-wheels",
    "rolling constraint": "wheels/wheels#the-rolling-row",
    "manoeuvrability": "wheels/wheels#how-many-ways-to-move",
    "mecanum": "glossary#term-Swedish-wheel-Mecanum-wheel-omni-wheel",
    "dead reckoning": "odometry/odometry#the-exercise",
    "covariance": "glossary#term-covariance",
    "null space": "planar_arm/planar_arm#a-glance-further",
    "manipulability": "planar_arm/planar_arm#how-near-is-it",
    "planar-arm-3": "planar_arm/planar_arm#planar-arm-3",
    "degree of freedom": "glossary#term-degree-of-freedom",
    "jacobain": "glossary#term-Jacobian",
    "FrameGraph": "api#robokin.frames.FrameGraph",
    "from_matrix": "api#robokin.euler.from_matrix",
    "wrap_angle": "api#robokin.motion.wrap_angle",
    "umbmark": "glossary#term-UMBmark-type-A-and-type-B",
    "Moodle": "teaching#in-moodle",
    "سینماتیک معکوس": "glossary#term-inverse-kinematics",
    "ژاكوبين": "glossary#term-Jacobian",  # with the Arabic kaf and ya
}
ASK = "(q) => siteSearch.ask(q).slice(0, 1).map(({page, at}) => at ? `${page}#${at}` : page)[0]"


def test_what_comes_first(site, server, chromium):
    """Thirty questions, over http."""
    with watched_page(chromium, server) as (page, watch):
        page.goto(server + "search.html?q=wheel")
        page.wait_for_selector(".site-results li")
        found = {words: page.evaluate(ASK, words) for words in FIRST}
        assert not watch.errors + watch.strangers
    wrong = {w: got for w, got in found.items() if not f"{got}#".startswith(f"{FIRST[w]}#")}
    assert not wrong


def test_a_result_leads_to_its_section(site, chromium):
    """From disk: typed in the dialog, chosen with the arrows."""
    home = site.as_uri() + "/"
    with watched_page(chromium, home, 390) as (page, watch):
        page.goto(home + "intro.html")
        page.locator(".search-button__button:visible").click()
        page.keyboard.type("rolling constr")
        results = page.locator("dialog .site-results li")
        results.first.filter(has_text="The rolling row").wait_for()
        assert results.first.locator("mark").first.text_content().lower() == "rolling"
        page.keyboard.press("ArrowDown")
        page.keyboard.press("Enter")
        page.wait_for_url("**/wheels.html#the-rolling-row")
        assert not watch.errors + watch.strangers
