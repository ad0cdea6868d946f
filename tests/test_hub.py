"""The hub of `book/hub.md`: its settings against the chart, its image, its commands."""

import re
from urllib.parse import urlsplit

import pytest
import yaml
from jsonschema import Draft7Validator
from support import ROOT

CHART = ROOT / "tests/site/vendor/zero-to-jupyterhub"
HUB = ROOT / "hub"
PAGE = (ROOT / "book/hub.md").read_text("utf-8")
COMMANDS = [
    line
    for info, block in re.findall(r"^```(.*)\n((?s:.)+?)^```$", PAGE, re.M)
    if not info
    for line in block.replace("\\\n", " ").splitlines()
]
VALUES = yaml.safe_load((HUB / "values.yaml").read_text("utf-8"))
CONFIG = VALUES["hub"]["config"]
STUDENT = VALUES["singleuser"]


def refusals(values):
    """What the chart has against some settings; what they leave out it has itself."""
    schema = yaml.safe_load((CHART / "values.schema.yaml").read_text("utf-8"))
    found = Draft7Validator(schema).iter_errors(values)
    return [f"{e.json_path}: {e.message}" for e in found if e.validator != "required"]


def test_the_chart_takes_the_settings():
    assert not refusals(VALUES)


@pytest.mark.parametrize(
    "wrong",
    [
        {"proxy": {"https": {"enabled": True, "host": ["hub.example.org"]}}},
        {"singleuser": {"storage": {"type": "shared"}}},
        {"singleuser": {"memory": {"guarantee": [350]}}},
        {"culling": {"enabled": True}},
    ],
)
def test_the_chart_refuses_other_settings(wrong):
    assert refusals(wrong)


def test_only_who_signs_in_enters_and_over_https():
    chosen = CONFIG["JupyterHub"]["authenticator_class"]
    assert chosen == "generic-oauth", "the chart's own lets anybody in as anybody"
    https = VALUES["proxy"]["https"]
    assert https["enabled"]
    assert https["letsencrypt"]["contactEmail"]
    addresses = [url for key, url in CONFIG["GenericOAuthenticator"].items() if "url" in key]
    assert {urlsplit(url).scheme for url in addresses} == {"https"}
    back = urlsplit(CONFIG["GenericOAuthenticator"]["oauth_callback_url"])
    assert (back.hostname, back.path) == (https["hosts"][0], "/hub/oauth_callback")
    assert CONFIG["Authenticator"]["admin_users"]
    assert "client_secret" not in CONFIG["GenericOAuthenticator"], "it would be committed"


def test_a_student_gets_an_own_folder_on_the_one_volume():
    claim = yaml.safe_load((HUB / "homes.yaml").read_text("utf-8"))
    assert claim["spec"]["accessModes"] == ["ReadWriteMany"]
    storage = STUDENT["storage"]
    assert storage["type"] == "static"
    assert storage["static"]["pvcName"] == claim["metadata"]["name"]
    (first,) = STUDENT["initContainers"]
    assert first["image"] == "{name}:{tag}".format(**STUDENT["image"])
    (mount,) = first["volumeMounts"]
    assert mount["subPath"] == storage["static"]["subPath"]
    assert mount["mountPath"] == first["command"][-1]


def test_the_image_is_the_same_whenever_it_is_built():
    text = (HUB / "Dockerfile").read_text("utf-8").replace("\\\n", " ")
    assert re.search(r"^FROM python:\d+\.\d+\.\d+-slim-\w+$", text, re.M)
    installs = re.findall(r"pip install [^&\n]+", text)
    assert installs
    assert all("--require-hashes" in each or "--no-index" in each for each in installs)


def test_hub_and_image_have_the_chart_s_jupyterhub():
    has = yaml.safe_load((CHART / "Chart.yaml").read_text("utf-8"))["appVersion"]
    lock = (HUB / "requirements.txt").read_text("utf-8")
    assert f"\njupyterhub=={has} " in lock
    assert "\nnbgitpuller==" in lock


def test_the_commands_are_whole():
    version = re.search(r"\d+\.\d+\.\d+", (CHART / "README.md").read_text("utf-8"))[0]
    installs = [line for line in COMMANDS if line.startswith("helm upgrade")]
    assert installs
    for line in installs:
        assert f"--version {version}" in line
        assert "--values hub/values.yaml" in line
    for line in COMMANDS:
        if re.match(r"helm upgrade|kubectl (?!get storageclass|create namespace)", line):
            assert "--namespace hub" in line
    files = re.findall(r"\bhub/[\w.]+", "\n".join(COMMANDS))
    assert {"hub/homes.yaml", "hub/values.yaml"} <= set(files)
    assert all((ROOT / name).is_file() for name in files)
    repository = next(k for k, line in enumerate(COMMANDS) if line.startswith("helm repo add"))
    assert repository < COMMANDS.index(installs[0])
