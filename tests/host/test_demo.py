"""The verdict of the demo, at its limits."""

from dataclasses import replace

import pytest
from host.staged import POSE, answer

from host_tool.demo import VERDICTS_MIN, Verdict, check_simulated, exit_code_of, verdict_on
from host_tool.errors import DeviceError, ExitCode
from host_tool.watching.tally import Summary

GOOD = Summary(15.0, 450, 0, 450, 30.0, valid_share=1.0, inside_share=0.9, rms_mm=0.1, worst_mm=0.3)


@pytest.mark.parametrize(
    ("summary", "code"),
    [
        (GOOD, ExitCode.PASS),
        (replace(GOOD, valid_share=0.95, inside_share=0.85), ExitCode.PASS),
        (replace(GOOD, valid_share=0.949), ExitCode.FAILED),
        (replace(GOOD, inside_share=0.849), ExitCode.FAILED),
        (replace(GOOD, valid_share=0.0, inside_share=None, poses=0), ExitCode.FAILED),
        (replace(GOOD, verdicts=VERDICTS_MIN), ExitCode.PASS),
        (replace(GOOD, verdicts=VERDICTS_MIN - 1), ExitCode.INCONCLUSIVE),
    ],
)
def test_the_verdict_follows_the_limits(summary: Summary, code: ExitCode) -> None:
    verdict = verdict_on(summary)
    assert verdict.exit_code is code
    assert bool(verdict.reasons) is (code is not ExitCode.PASS)


@pytest.mark.parametrize(
    ("code", "endless", "ends"),
    [
        (ExitCode.INCONCLUSIVE, True, ExitCode.PASS),
        (ExitCode.INCONCLUSIVE, False, ExitCode.INCONCLUSIVE),
        (ExitCode.FAILED, True, ExitCode.FAILED),
        (ExitCode.PASS, True, ExitCode.PASS),
    ],
)
def test_only_a_run_that_ctrl_c_ends_may_end_before_its_verdict(code: ExitCode, endless: bool, ends: ExitCode) -> None:
    assert exit_code_of(Verdict(code), endless) is ends


def test_a_unit_that_measures_the_real_world_is_refused() -> None:
    with pytest.raises(DeviceError, match="E-DEM-01"):
        check_simulated(answer(replace(POSE, status=0)))
