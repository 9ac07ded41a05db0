"""Whole responses: the answers are those of the program, and what is known of them."""

from pathlib import Path

import numpy as np
import pytest

import chattercheck as cc

from conftest import ROOT, Program

# p = 1: times in seconds are those in tau.
ONE = cc.Block(radius=0.75 * 9.81, slenderness=0.2, restitution=0.6)
ONE_SINE = cc.GroundMotion.one_sine(1.02, omega=2, units="threshold")
RESTS = [1.158296102357345982791668, 2.257017229112942522561358, 2.729092429152242602022990]


def test_a_known_response() -> None:
    found = cc.rock(ONE, ONE_SINE, model="linear")
    assert found.frequency_parameter == 1
    first, again, second = RESTS
    off = found.rest_uncertainty
    assert abs(found.rests[1, 0] - first) <= off[1] < 1e-12
    assert abs(found.rests[2, 0] - second) <= off[2] < 1e-12
    assert abs(found.rests[1, 1] - again) < 1e-14
    assert (found.status, found.success) == (0, True)
    assert [bout.ending for bout in found.bouts] == ["complete", "complete"]


def test_rotations_and_events_fit_together() -> None:
    found = cc.rock(cc.Block(0.6, 2.0), cc.GroundMotion.ricker(0.4, 1.0, 1.5), (0, 4))
    assert found.t.shape == found.theta.shape == found.velocity.shape == found.acceleration.shape == found.state.shape
    assert np.all(np.diff(found.t) >= 0) and np.all(np.diff(found.t_events) >= 0)
    assert found.t[-1] == found.end and found.end == pytest.approx(4)
    assert np.max(np.abs(found.acceleration)) == pytest.approx(0.4, rel=1e-3)
    at_impacts = np.isin(found.t, found.t_events)
    assert at_impacts.any() and np.all(found.theta[at_impacts] == 0)
    assert found.events is found.t_events and found.velocity_events.shape == found.t_events.shape == found.intervals.shape
    assert "rocking" in found.message and found.summary["ending"] == "rocking"
    largest = found.summary["largest_rotation"]["degrees"]
    assert np.degrees(np.max(np.abs(found.theta))) == pytest.approx(abs(largest), rel=1e-4)


def test_a_block_that_overturns() -> None:
    found = cc.rock(cc.Block(0.2, 2.0), cc.GroundMotion.one_sine(1.0, 0.5))
    assert (found.status, found.success) == (1, True)
    assert found.state[-1] == "lying" and abs(found.theta[-1]) == pytest.approx(np.pi / 2)
    assert "overturned" in found.message


def test_a_record_in_memory_is_one_in_a_file(tmp_path: Path, program: Program) -> None:
    acc = np.random.default_rng(7).normal(scale=0.15, size=300)
    path = tmp_path / "record.csv"
    path.write_text("\n".join(map(repr, acc.tolist())) + "\n")
    scene = tmp_path / "scene.toml"
    scene.write_text(
        f'[block]\nwidth = 0.6\nheight = 2.0\nrestitution = "housner"\n[ground]\nrecord = {{ file = "{path.name}", units = "g", dt = {{ seconds = 0.02 }} }}\n'
    )
    told = program("response", str(scene), "--format", "json", "--impacts", "50")
    block = cc.Block(0.6, 2.0)
    for motion in (cc.GroundMotion(acc, 0.02), cc.GroundMotion.read(path, units="g", dt=0.02), cc.GroundMotion(acc * 9.81, 0.02, "m/s2")):
        found = cc.rock(block, motion)
        p = found.frequency_parameter
        assert len(found.bouts) == len(told["bouts"]) > 0
        for mine, theirs in zip(found.bouts, told["bouts"]):
            assert mine.ending == theirs["ending"]
            np.testing.assert_allclose([mine.start * p, mine.end * p], [theirs["from"], theirs["to"]], rtol=1e-9)
            if theirs["uncertainty"] is None:
                assert np.isnan(mine.uncertainty)
            elif motion.units == "g":
                assert mine.uncertainty * p >= theirs["uncertainty"]


def test_a_file_of_peer(tmp_path: Path) -> None:
    path = tmp_path / "a.AT2"
    path.write_text("PEER\nMade up\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 5, DT= .0100 SEC\n .1E+00 .2E+00 .3E+00 -.1E+00 .0E+00\n")
    motion = cc.GroundMotion.at2(path)
    assert (list(motion.acc), motion.dt, motion.units, motion.format) == ([0.1, 0.2, 0.3, -0.1, 0.0], 0.01, "g", "PEER AT2")
    assert repr(motion) == "GroundMotion(5 samples in g)"
    rows = tmp_path / "rows.txt"
    rows.write_text("0.1 0.2 0.3\n")
    with pytest.raises(ValueError, match="the format is numbers in rows|does not name its units"):
        cc.GroundMotion.at2(rows)
    with pytest.raises(ValueError, match="the scene units"):
        cc.GroundMotion.read(path, units="m/s2")


MOTIONS = {
    "one-cosine": cc.GroundMotion.one_cosine(0.5, 1.0),
    "ricker": cc.GroundMotion.ricker(0.5, 1.0, 1.5, antisymmetric=True),
    "mavroeidis": cc.GroundMotion.mavroeidis_papageorgiou(0.5, 1.0, 1.5, 0.3),
    "sine": cc.GroundMotion.sine(0.4, 1.0, phase=0.0, cycles=3),
    "sinusoids": cc.GroundMotion.sinusoids([0.3, 0.2], [1.0, 2.5], [0.1, 0.0], duration=3.0),
    "tau": cc.GroundMotion.ricker(1.5, omega=2, center_tau=3, units="threshold"),
}


@pytest.mark.parametrize("name", MOTIONS)
def test_every_motion_is_followed(name: str) -> None:
    found = cc.rock(cc.Block(0.6, 2.0), MOTIONS[name])
    assert found.success and len(found.bouts) > 0 and len(found.t_events) > 0


def test_released_from_half_alpha() -> None:
    still = cc.GroundMotion([0.0, 0.0], dt_tau=1.0)
    block = cc.Block(radius=0.75 * 9.81, slenderness=0.2, restitution=0.9)
    found = cc.rock(block, still, model="linear", rotation=0.5)
    assert found.t_events[0] == pytest.approx(1.31695789692, abs=1e-11)
    assert found.bouts[0].end == pytest.approx(18.5189610108, abs=1e-10)


def test_criterion() -> None:
    found = cc.criterion(ONE, ONE_SINE, model="linear")
    first = found.bouts[0]
    assert first.rest_lower is not None and first.rest_upper is not None and first.predicted_rest is not None
    assert first.rest_lower <= RESTS[0] <= first.rest_upper
    assert first.predicted_uncertainty is not None and abs(first.predicted_rest - RESTS[0]) <= first.predicted_uncertainty
    assert first.gap_end == pytest.approx(RESTS[1])
    assert found.incomplete_upper is not None and 1.02 * found.incomplete_upper == pytest.approx(1.122593927069742)


def test_overturning_is_that_of_the_program(program: Program, tmp_path: Path) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text(
        '[block]\nwidth = 0.4\nheight = 2.0\nrestitution = "housner"\n[ground]\npulse = "one-sine"\namplitude = { g = 0.5 }\nfrequency = { hz = 1.0 }\n'
    )
    told = program("overturning", str(scene), "--from", "0.5", "--to", "1.5", "--format", "json")
    found = cc.overturning(cc.Block(0.4, 2.0), cc.GroundMotion.one_sine(0.5, 1.0), (0.5, 1.5))
    for mine, theirs in ((found.overturning, told["overturning"]), (found.incomplete, told["incomplete"])):
        assert (mine.lower, mine.upper, mine.certified) == (theirs["lower"], theirs["upper"], theirs["certified"])
        assert mine.happens_at_from == theirs["happens_at_from"] and len(mine.changes) == len(theirs["changes"])


def test_plan_is_that_of_the_program(program: Program) -> None:
    told = program("plan", str(ROOT / "data/scenes/bookcase.toml"), "--format", "json")
    block = cc.Block(0.6, 2.0)
    found = cc.plan(block, cc.GroundMotion.sine(0.35, 1.0), 1e-3)
    assert found.chosen in {of.method for of in found.candidates}
    assert {of["method"] for of in told["candidates"]} == {of.method for of in found.candidates}
    both = cc.plan(block, cc.GroundMotion.one_sine(0.5, 1.0), 1e-3)
    assert both.chosen == "taylor" and both.candidates[0].model_error != 0
