"""The search: what must come first, results while typing, and by keyboard."""

import tomllib
from collections import Counter

import pytest
import search
from browser import watched_page

pytest_plugins = ["browser"]

# What a reader types, and the page or section that must come first.
ARM, EULER, FRAMES = "elbow_arm/elbow_arm", "euler/euler", "frames/frames"
DRIVE, CAR, WHEELS = "differential_drive/differential_drive", "bicycle/bicycle", "wheels/wheels"
ODOMETRY, PLANAR, TERM = "odometry/odometry", "planar_arm/planar_arm", "glossary#term-"
FIRST = {
    # a chapter by a word of its title
    "inverse kinematics": ARM,
    "Euler rotation": EULER,
    "frame chain": FRAMES,
    "differential drive": DRIVE,
    "bicycle": CAR,
    "omni": WHEELS,
    "odometry": ODOMETRY,
    "encoder": ODOMETRY,
    "velocity kinematics": PLANAR,
    # the field's words
    "law of cosines": f"{ARM}#first-way-three-angles",
    "atan2": f"{ARM}#second-way-a-cosine-the-rest-with-atan2",
    "workspace": f"{TERM}workspace-reachable-workspace",
    "lost digits": f"{ARM}#the-form-that-keeps-its-digits",
    "gimbal lock": f"{TERM}gimbal-lock",
    "axis angle": f"{TERM}axisangle",
    "rotation matrix": "basics/basics#a-turn-is-a-matrix",
    "quaternion": f"{EULER}#",
    "homogeneous transform": f"{FRAMES}#a-pose-as-a-matrix",
    "loop closure": f"{FRAMES}#loop-closure-as-a-test",
    "camera": f"{FRAMES}#a-camera-that-looks-down",
    "ICR": f"{TERM}ICR-instantaneous-centre-of-rotation",
    "nonholonomic": f"{DRIVE}#where-it-fails",
    "lane": f"{CAR}#the-lane",
    "turning circle": f"{TERM}turning-circle",
    "slip angle": f"{TERM}slip-angle",
    "Ackermann": f"{WHEELS}#a-car-s-front-wheels",
    "rolling constraint": f"{WHEELS}#the-rolling-row",
    "manoeuvrability": f"{WHEELS}#how-many-ways-to-move",
    "mecanum": f"{TERM}Swedish-wheel-Mecanum-wheel-omni-wheel",
    "dead reckoning": f"{ODOMETRY}#the-exercise",
    "covariance": f"{TERM}covariance",
    "null space": f"{PLANAR}#a-glance-further",
    "manipulability": f"{PLANAR}#how-near-is-it",
    "damped least squares": f"{TERM}damped-least-squares",
    "degree of freedom": f"{ARM}#the-exercise",
    "pseudoinverse": f"{TERM}pseudoinverse",
    "offtracking": f"{TERM}off-tracking",
    "sinc": f"{DRIVE}#where-will-it-be",
    # symbols
    "φ": "notation#wheel-constraints-and-the-omni-robot",
    "v_L": f"{DRIVE}#the-point-that-stands-still",
    # functions, and errors
    "FrameGraph": "api#robokin.frames.FrameGraph",
    "from_matrix": "api#robokin.euler.from_matrix",
    "wrap_angle": "api#robokin.motion.wrap_angle",
    "arc_step": "api#robokin.motion.arc_step",
    "LinAlgError": f"{TERM}LinAlgError-singular-matrix",
    "ValueError": f"{FRAMES}#where-it-fails",
    "out of reach": f"{ARM}#laboratory",
    "umbmark": f"{TERM}UMBmark-type-A-and-type-B",
    # mistakes and exercises
    "M1": f"{ARM}#M1",
    "M8": f"{EULER}#M8",
    "half the wheel distance": f"{DRIVE}#M12",
    "euler-3": f"{EULER}#euler-3",
    "planar-arm-3": f"{PLANAR}#planar-arm-3",
    # slips
    "jacobain": f"{TERM}Jacobian",
    "bycicle": CAR,
    "odomtery": ODOMETRY,
    "differental drive": DRIVE,
    "gimball lock": f"{TERM}gimbal-lock",
    # Persian; one with the Arabic kaf and ya
    "سینماتیک معکوس": f"{TERM}inverse-kinematics",
    "ژاكوبين": f"{TERM}Jacobian",
    "ادومتری": f"{TERM}dead-reckoning-odometry",
    "قفل گیمبال": f"{TERM}gimbal-lock",
    # teachers and students
    "Moodle": "teaching#in-moodle",
    "offline": "intro#for-students",
}
ASK = "(q) => siteSearch.ask(q).slice(0, 1).map(({page, at}) => at ? `${page}#${at}` : page)[0]"


@pytest.mark.browser
def test_what_comes_first(site, server, chromium):
    """Sixty questions, over http; "page#" is any section of a page."""
    with watched_page(chromium, server) as (page, watch):
        page.goto(server + "search.html?q=wheel")
        page.wait_for_selector(".site-results li")
        found = {words: page.evaluate(ASK, words) for words in FIRST}
        assert not watch.errors + watch.strangers
    wrong = {
        words: got
        for words, got in found.items()
        if got != FIRST[words] and not (FIRST[words].endswith("#") and got.startswith(FIRST[words]))
    }
    assert not wrong


@pytest.mark.browser
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
