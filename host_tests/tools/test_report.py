# SPDX-License-Identifier: MIT
"""make report: the page stands by itself and says what was measured."""

import html.parser
import json
import re

import pytest
from conftest import CHECKOUT, assert_one_sentence, run_cli

import report as report_tool

SCENE = "scenes/tiny.toml"


class Page(html.parser.HTMLParser):
    """Every attribute that could fetch something, and whether the tags nest."""

    VOID = {"meta", "img", "link", "br", "path", "use"}

    def __init__(self, text):
        super().__init__()
        self.references, self.ids, self.open = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.references += [value for name, value in attrs if name in ("src", "href", "xlink:href")]
        self.ids += [value for name, value in attrs if name == "id"]
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.references += [value for name, value in attrs if name in ("src", "href", "xlink:href")]
        self.ids += [value for name, value in attrs if name == "id"]

    def handle_endtag(self, tag):
        if tag not in self.VOID:
            assert self.open.pop() == tag


@pytest.fixture(scope="module")
def result(build, tmp_path_factory):
    out = tmp_path_factory.mktemp("report") / "out"
    done = run_cli("report", "--scene", SCENE, "--frames", 6, "--samples", 2000, "--out", out)
    assert done.returncode == 0, done.stdout + done.stderr
    return json.loads((out / "report.json").read_text()), (out / "report.html").read_text(), done


def test_every_stage_on_both_inputs(result):
    report, _, _ = result
    assert {(row["stage"], row["input"]) for row in report["stages"]} == \
        {(stage, kind) for stage in report_tool.STAGES for kind in ("scene", "random")}
    for row in report["stages"]:
        assert row["samples"] > 0 and 0 <= row["mean"] <= row["max"] and row["unit"]


def test_frames_and_third_judge(result):
    report, _, _ = result
    assert [frame["frame"] for frame in report["frames"]] == list(range(6))
    assert sum(frame["pixels_differing"] for frame in report["frames"]) == report["pixels_differing"]
    assert report["third_judge"]["frames_judged"] > 0


def test_page_fetches_nothing(result):
    page = Page(result[1])
    assert page.open == []
    assert page.references
    assert all(reference.startswith(("data:image/png;base64,", "#")) for reference in page.references)
    # Names of XML namespaces are not fetched.
    named = set(re.findall(r"https?://[^\"'<> )]+", result[1]))
    assert all("www.w3.org" in each or "purl.org" in each or "creativecommons" in each or
               "matplotlib.org" in each for each in named)
    assert "@import" not in result[1] and "<script" not in result[1]


def test_ids_of_the_plots_do_not_clash(result):
    ids = Page(result[1]).ids
    assert len(ids) == len(set(ids))


def test_page_shows_the_figures(result):
    report, page, _ = result
    assert f"{report['pixels']:,}" in page
    assert page.count("<svg") == len(report_tool.STAGES) + 1
    assert page.count("data:image/png") >= 3


def test_table_names_the_stages(result):
    assert all(stage in result[2].stdout for stage in report_tool.STAGES)


def test_what_is_wrong_makes_a_sentence():
    stage = {"stage": "clip", "input": "random", "samples": 9, "max": 1.0, "mean": 0.5, "unit": "u"}
    good = {"pixels_unexplained": 0, "third_judge": {"pixels_unexplained": 0}, "stages": [stage]}
    assert report_tool.complaints(good) == []
    assert report_tool.complaints({**good, "pixels_unexplained": 2})
    assert report_tool.complaints({**good, "third_judge": {"pixels_unexplained": 1}})
    assert report_tool.complaints({**good, "stages": [{**stage, "beyond_bound": 1}]})
    assert report_tool.complaints({**good, "stages": [{**stage, "mismatched": 1}]})


def test_bad_scene_leaves_nothing(build, tmp_path):
    (tmp_path / "bad.fxls").write_bytes(b"FXLS")
    done = run_cli("report", "--scene", tmp_path / "bad.fxls", "--out", tmp_path / "out")
    assert_one_sentence(done, "bad.fxls", code=done.returncode)
    assert done.returncode and not (tmp_path / "out").exists()
    assert not list((CHECKOUT / "build").glob(".report-*/*"))
